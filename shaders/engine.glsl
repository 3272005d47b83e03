// Shading of an exported texture set in engines: Lambert, anisotropic GGX and a sheen that depends on the engine. The
// first kind is what three.js r187 does, operation by operation; method `engine` is it.
// GLSL 3.30 and C++20. Frame: x along the wider axis of the highlight, z the normal.
//
// Based on: Walter et al. 2007 and Heitz 2014 (anisotropic GGX); Estevez, Kulla 2017, Neubelt, Pettineo 2013 (Charlie
// sheen of glTF and HDRP); Zeltner, Burley, Chiang 2022, by the rational fits of MaterialX 1.39 (fuzz of OpenPBR and
// Blender 4); Ashikhmin, Premoze 2007 as in Unreal's cloth model (inverse GGX); Burley 2012 (sheen of U3M's principled
// shader, body of that and of Blender 3's); Turquin 2019, "Practical multiple scattering compensation for microfacet
// models", by a polynomial through three.js' table (RMS 0.02).

#ifndef FORMULA
#define FORMULA
#endif

const int kSheenNone = 0;
const int kSheenCharlie = 1;
const int kSheenZeltner = 2;
const int kSheenInverseGgx = 3;
const int kSheenDisney = 4;
const int kSheenNoneDisney = 5;          // none, over Disney's body
const int kSheenNoneAdded = 6;           // none; the body loses nothing to round highlights that lean (EEVEE)

const float kEngineF0 = 0.04f;          // of dielectrics, in every engine
const float kMinEngineAlpha = 0.002f;  // roughness 0.045

struct EngineMaterial {
  vec3 base;
  float metal;
  vec3 sheen;
  float sheen_roughness;
  vec2 alpha;  // along the frame's x and y
  vec3 f0;     // reflectance of the dielectric at normal incidence
  float f90;   // at grazing incidence
  float occlusion;
};

// For unit irradiance at normal incidence.
struct EngineParts {
  vec3 body;     // diffuse, and the specular part of metals
  vec3 gloss;    // specular part of the dielectric for f0 = 1
  vec3 grazing;  // and for f90 = 1
  vec3 fuzz;
  float kept;            // fraction of body and gloss that the sheen leaves
};

// Albedo of Charlie sheen by the cosine of the view, three.js' fit.
FORMULA float charlie_albedo(float mu, float roughness) {
  float inverse = 1.0f / (roughness + 0.1f);
  float a = -1.9362f + 1.0678f * roughness + 0.4573f * roughness * roughness - 0.8469f * inverse;
  float b = -0.6014f + 0.5538f * roughness - 0.4670f * roughness * roughness - 0.1255f * inverse;
  return clamp(exp(a * mu + b), 0.0f, 1.0f);
}

FORMULA float charlie_sheen(float nh, float nl, float nv, float roughness) {
  float inverse = 1.0f / max(roughness * roughness, 1.0e-4f);
  float sine2 = max(1.0f - nh * nh, 0.0078125f);
  float d = (2.0f + inverse) * pow(sine2, 0.5f * inverse) / (2.0f * kPi);
  return d * clamp(0.25f / max(nl + nv - nl * nv, 1.0e-4f), 0.0f, 1.0f);
}

FORMULA float zeltner_albedo(float mu, float y) {
  float s = y * (0.0206607f + 1.58491f * y) / (0.0379424f + y * (1.32227f + y));
  float m = y * (-0.193854f + y * (-1.14885f + y * (1.7932f - 0.95943f * y * y))) / (0.046391f + y);
  float o = y * (0.000654023f + (-0.0207818f + 0.119681f * y) * y) / (1.26264f + y * (-1.92021f + y));
  float z = (mu - m) / s;
  return clamp(exp(-0.5f * z * z) / (s * 2.5066283f) + o, 0.0f, 1.0f);
}

// wi, wo in a frame whose z is the normal.
FORMULA float zeltner_sheen(vec3 wi, vec3 wo, float y) {
  float x = clamp(wo.z, 0.0f, 1.0f);
  float a = (2.58126f * x + 0.813703f * y) * y / (1.0f + 0.310327f * x * x + 2.60994f * x * y);
  float b = sqrt(1.0f - x) * (y - 1.0f) * y * y * y / (0.0000254053f + 1.71228f * x - 1.71506f * x * y + 1.34174f * y * y);
  float flat_length = sqrt(wo.x * wo.x + wo.y * wo.y);
  vec2 d = flat_length > 1.0e-5f ? vec2(wo.x, wo.y) / flat_length : vec2(1.0f, 0.0f);
  float along = wi.x * d.x + wi.y * d.y;                     // in the plane of the view
  float across = wi.y * d.x - wi.x * d.y;
  float lx = a * (along + b * wi.z);
  float ly = a * across;
  float length2 = max(lx * lx + ly * ly + wi.z * wi.z, 1.0e-8f);
  float over = a / length2;
  return zeltner_albedo(x, y) * over * over / kPi;           // over the light's cosine, which the caller multiplies
}

FORMULA float inverse_ggx_sheen(float nh, float nl, float nv, float roughness) {
  float a2 = roughness * roughness * roughness * roughness;
  float d = (nh - a2 * nh) * nh + a2;
  float density = (1.0f + 4.0f * a2 * a2 / max(d * d, 1.0e-8f)) / (kPi * (1.0f + 4.0f * a2));
  return density * 0.25f / max(nl + nv - nl * nv, 1.0e-4f);
}

// Energy that a lobe loses to masking, over what it keeps.
FORMULA float engine_loss(float mu, float roughness) {
  float r = clamp(roughness, 0.0f, 1.0f);
  float a = 2.7166f + mu * (-7.5874f + mu * 5.1539f);
  float b = -6.3507f + mu * (24.2405f - mu * 19.9307f);
  float c = 3.7680f + mu * (-14.5021f + mu * 14.7363f);
  return max(r * r * (a + r * (b + r * c)), 0.0f);
}

// Diffuse term of Disney's principled shader over Lambert's, without energy conservation.
FORMULA float disney_body(float nl, float nv, float lh, float roughness) {
  float l = 1.0f - nl;
  float v = 1.0f - nv;
  float l5 = l * l * l * l * l;
  float v5 = v * v * v * v * v;
  float back = 2.0f * roughness * lh * lh;
  return (1.0f - 0.5f * l5) * (1.0f - 0.5f * v5) + back * (l5 + v5 + l5 * v5 * (back - 1.0f));
}

// Cosine for Fresnel's law where round lobes with normals that lean along x make up the lobe, and know of the view and their
// own normal alone: of the lean that is most likely for the half vector, whose remaining part is the width of a round lobe.
FORMULA float leaning_cosine(vec3 h, vec3 wo, float ax, float ay) {
  float lean = h.x / max(h.z, 1.0e-3f) * max(1.0f - ay * ay / (ax * ax), 0.0f);
  return dot(normalize(vec3(lean, 0.0f, 1.0f)), wo);
}

// Light from or to w that the sheen keeps from the body, as a fraction for a sheen of 1.
FORMULA float sheen_albedo(EngineMaterial m, int sheen, vec3 w) {
  float mu = clamp(w.z, 1.0e-3f, 1.0f);
  if (sheen == kSheenCharlie) return charlie_albedo(mu, m.sheen_roughness);
  if (sheen == kSheenZeltner) return zeltner_albedo(mu, clamp(m.sheen_roughness, 0.01f, 1.0f));
  return 0.0f;
}

// sheen_wi, sheen_wo: sheen_albedo() of the directions.
FORMULA EngineParts engine_parts(EngineMaterial m, int sheen, vec3 wi, vec3 wo, float sheen_wi, float sheen_wo) {
  EngineParts p;
  p.body = vec3(0.0f);
  p.gloss = vec3(0.0f);
  p.grazing = vec3(0.0f);
  p.fuzz = vec3(0.0f);
  p.kept = 1.0f;
  if (wi.z <= 0.0f) return p;
  float nl = min(wi.z, 1.0f);
  float nv = clamp(wo.z, 1.0e-3f, 1.0f);
  vec3 h = normalize(wi + wo);
  float ax = clamp(m.alpha.x, kMinEngineAlpha, 1.0f);
  float ay = clamp(m.alpha.y, kMinEngineAlpha, 1.0f);
  float q = h.x * h.x / (ax * ax) + h.y * h.y / (ay * ay) + h.z * h.z;
  float d = 1.0f / (kPi * ax * ay * q * q);
  float g_o = nl * length(vec3(ax * wo.x, ay * wo.y, nv));
  float g_i = nv * length(vec3(ax * wi.x, ay * wi.y, nl));
  float shine = d * 0.5f / max(g_o + g_i, 1.0e-6f);
  float cosine = sheen == kSheenNoneAdded ? leaning_cosine(h, wo, ax, ay) : dot(wo, h);
  float k = 1.0f - clamp(cosine, 0.0f, 1.0f);
  float k5 = k * k * k * k * k;
  // Only glTF's kind compensates the loss of rough lobes.
  float loss = sheen == kSheenCharlie ? engine_loss(nv, sqrt(min(ax, ay))) : 0.0f;
  vec3 dielectric = clamp(m.f0 + (m.f90 - m.f0) * k5, vec3(0.0f), vec3(1.0f));
  vec3 body = (1.0f - dielectric) * ((1.0f - m.metal) / kPi);
  if (sheen == kSheenDisney || sheen == kSheenNoneDisney)
    body = vec3(1.0f - m.metal) * disney_body(nl, nv, 1.0f - k, sqrt(sqrt(ax * ay))) / kPi;
  if (sheen == kSheenNoneAdded) body = vec3((1.0f - m.metal) / kPi);
  vec3 metal = (m.base + (1.0f - m.base) * k5) * (1.0f + m.base * loss) * (m.metal * shine);
  p.body = (m.base * body + metal) * nl;
  vec3 mirrored = (1.0f + m.f0 * loss) * ((1.0f - m.metal) * shine * nl);
  p.gloss = mirrored * (1.0f - k5);
  p.grazing = mirrored * k5;
  float most = max(max(m.sheen.x, m.sheen.y), m.sheen.z);
  if (sheen == kSheenCharlie) {
    p.fuzz = m.sheen * (charlie_sheen(h.z, nl, nv, m.sheen_roughness) * nl);
    p.kept = 1.0f - most * max(sheen_wo, sheen_wi);
  } else if (sheen == kSheenZeltner) {
    p.fuzz = m.sheen * (zeltner_sheen(wi, wo, clamp(m.sheen_roughness, 0.01f, 1.0f)) * nl);
    p.kept = 1.0f - most * sheen_wo;
  } else if (sheen == kSheenInverseGgx) {
    p.fuzz = m.sheen * (inverse_ggx_sheen(h.z, nl, nv, sqrt(sqrt(ax * ay))) * nl);
    p.kept = 1.0f;
  } else if (sheen == kSheenDisney) {
    p.fuzz = m.sheen * (k5 * (1.0f - m.metal) * nl);
  }
  return p;
}

FORMULA EngineParts engine_parts(EngineMaterial m, int sheen, vec3 wi, vec3 wo) {
  return engine_parts(m, sheen, wi, wo, sheen_albedo(m, sheen, wi), sheen_albedo(m, sheen, wo));
}

// Of an even sky, what GGX of a roughness reflects with a reflectance of 1 at normal view (x) and at grazing view (y).
// Karis 2014, "Physically based shading on mobile".
FORMULA vec2 ggx_albedos(float mu, float roughness) {
  float r = 1.0f - roughness;
  float a = min(r * r, exp2(-9.28f * mu)) * r + 0.0425f - 0.0275f * roughness;
  return 1.04f * vec2(-a, a) + vec2(1.04f - 0.572f * roughness, 0.022f * roughness - 0.04f);
}

// Towards wo; f: frame of the material's normal. diffuse and glossy: fractions of the sky, with ambient occlusion as
// engines apply it.
FORMULA Reflected engine_radiance(EngineMaterial m, LobeFrame f, vec3 l, vec3 v) {
  vec3 wo = lobe_local(f, v);
  EngineParts p = engine_parts(m, kSheenCharlie, lobe_local(f, l), wo);
  float fuzz = charlie_albedo(clamp(wo.z, 0.0f, 1.0f), m.sheen_roughness);
  float kept = 1.0f - max(max(m.sheen.x, m.sheen.y), m.sheen.z) * fuzz;
  Reflected a;
  a.key = (p.body + p.gloss * m.f0 + p.grazing * m.f90) * p.kept + p.fuzz;
  // Fdez-Aguera 2019: what leaves the facets at once, and after more than one.
  vec2 by = ggx_albedos(clamp(wo.z, 0.0f, 1.0f), sqrt(min(m.alpha.x, m.alpha.y)));
  vec3 f0 = mix(m.f0, m.base, m.metal);
  vec3 once = f0 * by.x + mix(m.f90, 1.0f, m.metal) * by.y;
  vec3 each = f0 + (1.0f - f0) / 21.0f;
  vec3 more = once * each * (1.0f - by.x - by.y) / (1.0f - (1.0f - by.x - by.y) * each);
  vec3 both = once + more;
  float enters = (1.0f - max(max(both.x, both.y), both.z)) * (1.0f - m.metal);
  a.diffuse = ((m.base * enters + more) * kept + m.sheen * fuzz) * m.occlusion;
  a.glossy = once * (kept * m.occlusion);
  return a;
}
