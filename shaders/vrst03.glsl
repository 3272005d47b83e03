// The BRDF of a whole cloth of the seed paper: facets of warp and weft as cylindrical Gaussians.
// GLSL 3.30 and C++20. Frame: x along the weft, y along the warp, z the cloth's normal.
//
//   exact:     vrst03_brdf(b, g(wi), g(wo), wi, wo), g from a table at vrst03_g_coord(w)
//   separable: cube_h(half vector) * cube_d(vrst03_difference(wi, wo))
//
// Based on: Adabala, Magnenat-Thalmann, Fei 2003, "Real-time rendering of woven clothes", section 3.3;
//   Ashikhmin, Premoze, Shirley 2000, "A microfacet-based BRDF generator", eq. 1-3;
//   Kautz, McCool 1999, "Interactive rendering with arbitrary BRDFs using separable approximations".
// Differs: the weight between the warp's and the weft's colour is symmetric in light and view, as
//   reciprocity asks; the paper gives no formula for it.

#ifndef FORMULA
#define FORMULA
#endif

struct Vrst03 {
  float f_warp;        // fractions of the surface, f_warp + f_weft = 1
  float f_weft;
  float sigma_warp;    // width of the Gaussian along the thread
  float sigma_weft;
  float c_warp;        // makes each p integrate to 1 over the hemisphere
  float c_weft;
  float mean_hn;       // <h.n>: mean of h.z over p
  vec3 warp_colour;    // Fresnel reflectance at normal incidence
  vec3 weft_colour;
};

// Cylindrical Gaussian with sigma_y infinite: only the slope along the thread counts (eq. 3 of both).
FORMULA float vrst03_thread(float slope_along, float sigma, float c) {
  float q = slope_along / max(sigma, 1.0e-3f);
  return c * exp(-min(q * q, 80.0f));
}

// p(h), 1/sr.
FORMULA float vrst03_p(Vrst03 b, vec3 h) {
  float z = max(h.z, 1.0e-5f);
  return b.f_warp * vrst03_thread(h.y / z, b.sigma_warp, b.c_warp)
       + b.f_weft * vrst03_thread(h.x / z, b.sigma_weft, b.c_weft);
}

// Fresnel reflectance (Schlick 1994); its colour changes from the warp's to the weft's towards grazing.
FORMULA vec3 vrst03_fresnel(Vrst03 b, vec3 wi, vec3 wo) {
  vec3 sum = wi + wo;
  float k = max(1.0f - 0.5f * length(sum), 0.0f);
  float k2 = k * k;
  float grazing = 1.0f - sqrt(max(wi.z, 0.0f) * max(wo.z, 0.0f));
  vec3 colour = mix(b.warp_colour, b.weft_colour, grazing);
  return colour + (1.0f - colour) * (k2 * k2 * k);
}

// Coordinates 0..1 of the table of g: it is even in x and in y.
FORMULA vec2 vrst03_g_coord(vec3 w) {
  float x = abs(w.x);
  float y = abs(w.y);
  return vec2(clamp(w.z, 0.0f, 1.0f), y / max(x + y, 1.0e-6f));
}

FORMULA vec3 vrst03_brdf(Vrst03 b, float g_i, float g_o, vec3 wi, vec3 wo) {
  if (wi.z <= 0.0f || wo.z <= 0.0f) return vec3(0.0f);
  vec3 h = normalize(wi + wo);
  return vrst03_fresnel(b, wi, wo) * (vrst03_p(b, h) * b.mean_hn / (4.0f * max(g_i * g_o, 1.0e-8f)));
}

// Light direction in the frame of the half vector, built from h and x by Gram-Schmidt (Kautz, McCool
// 1999, section 4): the second coordinate of the separable form.
FORMULA vec3 vrst03_difference(vec3 wi, vec3 wo) {
  vec3 h = normalize(wi + wo);
  vec3 t = vec3(1.0f, 0.0f, 0.0f) - h * h.x;
  float t2 = dot(t, t);
  t = t2 > 1.0e-8f ? t * inversesqrt(max(t2, 1.0e-8f)) : vec3(0.0f, 1.0f, 0.0f);
  return vec3(dot(wi, t), dot(wi, cross(h, t)), dot(wi, h));
}
