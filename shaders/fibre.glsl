// Light that one fibre scatters: a clear or dyed cylinder whose surface is slightly rough. Light is reflected at the
// surface (R), passes through (TT), is reflected once inside (TRT) or more often. GLSL 3.30 and C++20.
//
//   FibreOptics f                          what the fibre is
//   fibre_scatter(f, h, wi, wo)            radiance along wo for unit irradiance perpendicular to the beam from wi
//   fibre_sample(f, h, wo, numbers)        a direction wi; fibre_density(f, h, wi, wo) is its density by solid angle
//
// Directions are unit vectors that point away from the fibre, in a frame with x along it. h, -1 to 1: the distance of
// the ray along wo from the axis, in radii, towards cross(x, wo). The mean over h is what a fibre sends that is thinner
// than a pixel; over x it is reciprocal as a BRDF is: fibre_scatter / sine(wi) is symmetric. The fractions of a fibre
// that absorbs nothing add up to 1 for each direction.
//
// Based on: Marschner et al. 2003 (R, TT, TRT; the cylinder's section by the angle between the two inclinations);
//   d'Eon et al. 2011 (inclinations normalised on the sphere); Chiang et al. 2016 (attenuations that add up to 1,
//   offset h, logistic azimuths).
// Differs: from d'Eon: the inclinations are those of a diffusion that is confined to the angles between the two ends of
//   the fibre: Marschner's Gaussian with its mirror images, over the two sines. It is normalised and reciprocal in
//   closed form. From Marschner: one width for all parts, without which the sum of the parts depends on the angle; no
//   tilt of scales.

#ifndef FORMULA
#define FORMULA
#endif

const float kFibrePi = 3.14159265f;
const float kMinFibreWidth = 0.01f;  // RMS, radians: about the sun's radius
const float kMaxFibreWidth = 0.4f;   // beyond, further images of the Gaussian would count
const float kMinFibreCosine = 1.0e-3f;

struct FibreOptics {
  float index;      // of refraction, >= 1
  vec3 absorption;  // for a length of one radius, >= 0
  float along;      // RMS angle by which light leaves its cone, radians
  float across;     // scale of the logistic distribution around the azimuth of a smooth cylinder, radians
  vec3 metal;       // reflectance at normal incidence of a metallic fibre, which transmits nothing; 0: dielectric
  float turbidity;  // fraction of the light inside that is scattered around the fibre by what is in it, 0..1
};

// Fractions of the light; they add up to 1 without absorption.
struct FibreParts {
  vec3 reflected;  // R
  vec3 through;    // TT
  vec3 inner;      // TRT
  vec3 rest;       // everything further and what turbid fibres scatter, even around the fibre
};

// Reflectance of a dielectric surface, unpolarised (Fresnel).
FORMULA float fibre_fresnel(float cosine, float index) {
  float c = clamp(cosine, 1.0e-4f, 1.0f);
  float t = sqrt(max(1.0f - (1.0f - c * c) / (index * index), 0.0f));
  float parallel = (index * c - t) / (index * c + t);
  float perpendicular = (c - index * t) / (c + index * t);
  return 0.5f * (parallel * parallel + perpendicular * perpendicular);
}

// Angle between the fibre and a direction, 0 to pi.
FORMULA float fibre_polar(vec3 w) { return atan(sqrt(w.y * w.y + w.z * w.z), w.x); }

FORMULA float fibre_width(FibreOptics f) { return clamp(f.along, kMinFibreWidth, kMaxFibreWidth); }
FORMULA float fibre_scale(FibreOptics f) { return clamp(f.across, kMinFibreWidth, 1.5f); }

// Sine and cosine of the angle that the section of the cylinder is taken at: half the difference of the inclinations,
// the same for both ways of the light (Marschner 2003, section 4).
FORMULA vec2 fibre_half_difference(float polar_i, float polar_o) {
  float half_angle = 0.5f * (polar_o - polar_i);
  return vec2(abs(sin(half_angle)), max(cos(half_angle), kMinFibreCosine));
}

// Sine of the ray's angle inside the section (Bravais' index; Marschner 2003, section 4.1).
FORMULA float fibre_inside(FibreOptics f, float h, vec2 angle) {
  float bravais = sqrt(max(f.index * f.index - angle.x * angle.x, 1.0e-6f)) / angle.y;
  return clamp(h / max(bravais, 1.0f), -1.0f, 1.0f);
}

// Chiang 2016, equations 8 to 13.
FORMULA FibreParts fibre_parts(FibreOptics f, float h, vec2 angle) {
  FibreParts p;
  float section = sqrt(max(1.0f - h * h, 0.0f));
  float cosine = angle.y * section;
  if (f.metal.x + f.metal.y + f.metal.z > 0.0f) {
    float k = 1.0f - cosine;
    p.reflected = f.metal + (vec3(1.0f) - f.metal) * (k * k * k * k * k);
    p.through = p.inner = p.rest = vec3(0.0f);
    return p;
  }
  float fresnel = fibre_fresnel(cosine, f.index);
  float sine_inside = fibre_inside(f, h, angle);
  float tilt = angle.x / f.index;
  float chord = 2.0f * sqrt(max(1.0f - sine_inside * sine_inside, 0.0f)) / sqrt(max(1.0f - tilt * tilt, 1.0e-6f));
  vec3 left = exp(-f.absorption * chord);
  p.reflected = vec3(fresnel);
  p.through = left * ((1.0f - fresnel) * (1.0f - fresnel));
  p.inner = p.through * left * fresnel;
  p.rest = p.inner * left * fresnel / max(vec3(1.0f) - left * fresnel, vec3(1.0e-4f));
  p.rest += (p.through + p.inner) * f.turbidity;
  p.through *= 1.0f - f.turbidity;
  p.inner *= 1.0f - f.turbidity;
  return p;
}

// Gaussian of the angles to the fibre, a of one direction and b of the mirrored other one, less its images beyond the
// two ends; over the sine of b.
FORMULA float fibre_cone(float a, float b, float width) {
  float variance = width * width;
  float off = a - b;
  float images = exp(-2.0f * a * b / variance) + exp(-2.0f * (kFibrePi - a) * (kFibrePi - b) / variance);
  float gauss = exp(0.5f * variance - 0.5f * off * off / variance) / (2.5066283f * width);
  return gauss * max(1.0f - images, 0.0f) / max(sin(b), 1.0e-4f);
}

// Density of an azimuth x away from that of the smooth cylinder (Chiang 2016, section 3.2).
FORMULA float fibre_logistic(float x, float scale) {
  float e = exp(-abs(x) / scale);
  float whole = (1.0f - exp(-kFibrePi / scale)) / (1.0f + exp(-kFibrePi / scale));
  return e / (scale * (1.0f + e) * (1.0f + e) * whole);
}

// By its inverse distribution; u in 0..1.
FORMULA float fibre_logistic_sample(float u, float scale) {
  float least = 1.0f / (1.0f + exp(kFibrePi / scale));
  float p = clamp(least + u * (1.0f - 2.0f * least), 1.0e-7f, 1.0f - 1.0e-7f);
  return clamp(scale * log(p / (1.0f - p)), -kFibrePi, kFibrePi);
}

// Azimuth of wi from that of wo on a smooth cylinder: 0 reflected, 1 through, 2 inner (Marschner 2003, section 5.2.1).
FORMULA float fibre_azimuth(FibreOptics f, float h, vec2 angle, int part) {
  float outside = asin(clamp(h, -1.0f, 1.0f));
  float inside = asin(fibre_inside(f, h, angle));
  return 2.0f * outside + float(part) * (kFibrePi - 2.0f * inside);
}

// x less its whole turns, -pi to pi.
FORMULA float fibre_turn(float x) { return x - 2.0f * kFibrePi * floor(x / (2.0f * kFibrePi) + 0.5f); }

// Densities of an azimuth (of wi from wo) by part: R, TT, TRT, rest.
FORMULA vec4 fibre_azimuths(FibreOptics f, float h, vec2 angle, float azimuth) {
  float scale = fibre_scale(f);
  vec4 n;
  n.x = fibre_logistic(fibre_turn(azimuth - fibre_azimuth(f, h, angle, 0)), scale);
  n.y = fibre_logistic(fibre_turn(azimuth - fibre_azimuth(f, h, angle, 1)), scale);
  n.z = fibre_logistic(fibre_turn(azimuth - fibre_azimuth(f, h, angle, 2)), scale);
  n.w = 0.5f / kFibrePi;
  return n;
}

FORMULA float fibre_azimuth_between(vec3 wi, vec3 wo) {
  return atan(wo.y * wi.z - wo.z * wi.y, wo.y * wi.y + wo.z * wi.z);
}

FORMULA vec3 fibre_scatter(FibreOptics f, float h, vec3 wi, vec3 wo) {
  float polar_i = fibre_polar(wi);
  float polar_o = fibre_polar(wo);
  vec2 angle = fibre_half_difference(polar_i, polar_o);
  FibreParts p = fibre_parts(f, h, angle);
  vec4 n = fibre_azimuths(f, h, angle, fibre_azimuth_between(wi, wo));
  float cone = fibre_cone(polar_i, kFibrePi - polar_o, fibre_width(f));
  return (p.reflected * n.x + p.through * n.y + p.inner * n.z + p.rest * n.w) * cone;
}

// Probabilities with which fibre_sample() chooses the parts, once the inclinations are known.
FORMULA vec4 fibre_choices(FibreOptics f, float h, vec2 angle) {
  FibreParts p = fibre_parts(f, h, angle);
  vec3 third = vec3(1.0f / 3.0f);
  vec4 weight = vec4(dot(p.reflected, third), dot(p.through, third), dot(p.inner, third), dot(p.rest, third));
  return weight / max(weight.x + weight.y + weight.z + weight.w, 1.0e-6f);
}

// The sampled angle to the fibre: distance from an end of it of a point that a Gaussian of three dimensions displaced,
// which is fibre_cone() near that end. numbers: three in 0..1. b: angle to the nearer end.
FORMULA float fibre_cone_sample(float b, float width, vec3 numbers) {
  float first = width * sqrt(-2.0f * log(max(1.0f - numbers.x, 1.0e-12f))) * cos(2.0f * kFibrePi * numbers.y);
  float others = -2.0f * width * width * log(max(1.0f - numbers.z, 1.0e-12f));
  return sqrt((b + first) * (b + first) + others);
}

FORMULA float fibre_cone_density(float a, float b, float width) {
  float variance = width * width;
  float near_b = max(b, 1.0e-4f);
  float off = a - near_b;
  return a / near_b * exp(-0.5f * off * off / variance) / (2.5066283f * width) *
         max(1.0f - exp(-2.0f * a * near_b / variance), 0.0f);
}

// A direction wi, or (0, 0, 0) if the light is lost; numbers: four in 0..1.
FORMULA vec3 fibre_sample(FibreOptics f, float h, vec3 wo, vec4 numbers) {
  float polar_o = fibre_polar(wo);
  float mirrored = kFibrePi - polar_o;
  bool far_end = mirrored > 0.5f * kFibrePi;
  float polar_i = fibre_cone_sample(far_end ? polar_o : mirrored, fibre_width(f), vec3(numbers.y, numbers.z, numbers.w));
  if (polar_i >= kFibrePi) return vec3(0.0f);
  if (far_end) polar_i = kFibrePi - polar_i;
  vec2 angle = fibre_half_difference(polar_i, polar_o);
  vec4 choice = fibre_choices(f, h, angle);
  float u = numbers.x;
  int part = 0;
  if (u >= choice.x) u -= choice.x, part = 1;
  if (part == 1 && u >= choice.y) u -= choice.y, part = 2;
  if (part == 2 && u >= choice.z) u -= choice.z, part = 3;
  float chosen = part == 0 ? choice.x : (part == 1 ? choice.y : (part == 2 ? choice.z : choice.w));
  u = clamp(u / max(chosen, 1.0e-6f), 0.0f, 1.0f);
  float azimuth = part == 3 ? 2.0f * kFibrePi * u
                            : fibre_azimuth(f, h, angle, part) + fibre_logistic_sample(u, fibre_scale(f));
  azimuth += atan(wo.z, wo.y);
  float sine = sin(polar_i);
  return vec3(cos(polar_i), sine * cos(azimuth), sine * sin(azimuth));
}

FORMULA float fibre_density(FibreOptics f, float h, vec3 wi, vec3 wo) {
  float polar_i = fibre_polar(wi);
  float polar_o = fibre_polar(wo);
  vec2 angle = fibre_half_difference(polar_i, polar_o);
  vec4 n = fibre_azimuths(f, h, angle, fibre_azimuth_between(wi, wo));
  float mirrored = kFibrePi - polar_o;
  bool far_end = mirrored > 0.5f * kFibrePi;
  float cone = far_end ? fibre_cone_density(kFibrePi - polar_i, polar_o, fibre_width(f))
                       : fibre_cone_density(polar_i, mirrored, fibre_width(f));
  return dot(fibre_choices(f, h, angle), n) * cone / max(sin(polar_i), 1.0e-4f);
}
