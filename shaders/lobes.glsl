// How light leaves a yarn: specular along the fibre, body, fuzz, transmission.
// GLSL 3.30 and C++20 (core/light/formulas.h). Directions are unit vectors that point away from the
// surface, in a frame with x along the fibre and z along the normal; results are BRDFs in 1/sr, to be
// multiplied by |wi.z|.
//
//   YarnLobes y           what the yarn is (core/light/yarn_lobes.h makes it from the design)
//   yarn_reflect(y, wi, wo), yarn_transmit(y, wi, wo), yarn_albedo(y, wo)
//   With several lights: lobe_shared(y) and lobe_side(y, shared, wo) once, then lobe_reflect() a light.
//   In batches: lobe_place(), a look-up, lobe_finish() are the parts of lobe_side().
//   Prefiltered: lobe_frame(mean normal, fibre), yarn_widen(y, lobe_covariance(frame, slope covariance)).
//
// The host declares the tables (shaders/tables.glsl, core/light/tables.h, which says what they hold):
//   vec4 albedo_table(float opening, float along, float across)
//   vec2 albedo_mean_table(float major, float minor)
//   vec4 fuzz_table(float opening, float depth)
//
// Based on: Beckmann, Spizzichino 1963 (Gaussian slopes); Smith 1967, Heitz 2014 (masking);
//   Kulla, Conty 2017 (energy compensation); Kelemen, Szirmay-Kalos 2001 (body under a specular coat);
//   Koenderink, Pont 2003 (fuzz as a thin layer of scatterers); Dupuy et al. 2013 (moments of slopes);
//   Stokes 1862, "On the intensity of the light reflected from or transmitted through a pile of plates" (layers of
//   fibres); Sadeghi et al. 2013 (light that went through fibres leaves near the same cone, dyed).
// Differs: from Dupuy: the lobe is centred in the frame of the mean normal, so that furnace and
//   reciprocity hold to the precision of the tables; from Koenderink and Pont: what the fuzz scatters
//   more than once is given back; from Sadeghi: dyed and clear light share one width, so that layers cost nothing.

#ifndef FORMULA
#define FORMULA
#endif

const float kPi = 3.14159265f;
const float kMinVariance = 2.5e-5f;  // RMS slope 0.005, about the sun's radius: D stays within half floats
const float kMaxVariance = 1.0e8f;
const float kMinCosine = 1.0e-4f;    // 89.994 degrees; below it 1 / mu is held

struct YarnLobes {
  vec3 slope_cov;      // covariance of the facets' slopes (xx, xy, yy), >= 0; x along the fibre
  vec3 f0;             // reflectance at normal incidence, 0..1
  float f90;           // reflectance at grazing incidence, 0..1
  float pile;          // >= 1: reflectance of the layers of fibres over that of one, at normal incidence
  vec3 body;           // share that comes back out of the body, 0..1
  vec3 through;        // share that comes out behind; body + through <= 1
  vec3 fuzz_colour;    // albedo of the fibres that stand off, 0..1
  float fuzz;          // share of the area they cover, 0..1
  float fuzz_depth;    // their optical depth along the normal, > 0
};

// What one set of lobes has for all directions.
struct LobeShared {
  vec3 cov;            // slope_cov made safe
  vec3 inverse;        // inverse of it (xx, xy, yy)
  float peak;          // density of slopes at its mean
  vec3 multiple;       // light scattered more than once: / (pi (1 - mean albedo))
  vec3 recurring;      // its share of what single scattering loses
  vec3 body_scale;     // 1 / (pi (1 - mean specular albedo))
  vec3 mean_enters;    // 1 - mean specular albedo
};

// Where one direction lies in the tables.
struct LobePlace {
  float mu;            // cosine, held above kMinCosine
  float area;          // projected area of the facets, over that of the plane's unit area
  float rim;           // mu + sine * along
  float opening;       // coordinates of the albedo table
  float along;
  float across;
  float mixed;         // squared correlation of the slopes along the plane of w and z and across it: that
                       // plane seldom holds a principal axis
};

// What one set of lobes has for one direction.
struct LobeSide {
  float mu;            // cosine, held above kMinCosine
  float area;          // projected area of the facets, over that of the plane's unit area
  float lost;          // 1 - albedo of single scattering
  vec3 enters;         // 1 - albedo of the whole specular part
  float clear;         // transmittance of the fuzz
  vec4 fuzz;           // fuzz_table
};

// Mean of max(0, x) for x Gaussian of mean mu >= 0 and deviation sigma: projected area of Gaussian
// facets (Heitz 2014, eq. 80). The error function is Abramowitz, Stegun 7.1.26 (1.5e-7).
FORMULA float gaussian_area(float mu, float sigma) {
  float nu = mu / max(sigma, 1.0e-9f);
  float bell = exp(-0.5f * min(nu * nu, 160.0f));
  float t = 1.0f / (1.0f + 0.23164190f * nu);
  float tail = 0.5f * bell * t * (0.254829592f + t * (-0.284496736f + t * (1.421413741f
             + t * (-1.453152027f + t * 1.061405429f))));
  return mu * (1.0f - tail) + sigma * 0.39894228f * bell;
}

FORMULA vec3 safe_covariance(vec3 c) {
  float xx = clamp(c.x, kMinVariance, kMaxVariance);
  float yy = clamp(c.z, kMinVariance, kMaxVariance);
  float bound = 0.99f * sqrt(xx) * sqrt(yy);
  return vec3(xx, clamp(c.y, -bound, bound), yy);
}

// Variance of the slopes along a direction of the plane (not normalised).
FORMULA float variance_along(vec3 cov, float x, float y) {
  return cov.x * x * x + 2.0f * cov.y * x * y + cov.z * y * y;
}

// 0..1 coordinate of a standard deviation 0..infinity.
FORMULA float spread_coordinate(float variance) {
  float s = sqrt(max(variance, 0.0f));
  return s / (1.0f + s);
}

// Schlick's weight of the grazing reflectance for a pile of layers: of n that each reflect r the whole reflects
// n r / (1 + (n - 1) r) (Stokes 1862). With Schlick's r that is f0 + (1 - f0) times this, exactly; pile: f0 over one
// layer's. It rises sooner than one surface's.
FORMULA float pile_grazing(float pile, float k) {
  float k2 = k * k;
  float q = k2 * k2 * k;
  return pile * q / (1.0f + (pile - 1.0f) * q);
}

// Mean of it over facets, of which one layer's mean is q: the weight bends down, so its mean is the less the more the
// facets differ. spread2: squares of the coordinates of their slopes. Fitted to the white furnace, as are those below.
FORMULA float pile_over_facets(float pile, float q, float spread2) {
  return pile * q / (1.0f + (pile - 1.0f) * q * (1.0f + 5.8f * spread2));
}

// The same over a hemisphere; spread: sum of the coordinates of the slopes, 0..2. Of flat facets exact to 1 percent.
FORMULA float pile_mean(float pile, float mean, float spread) {
  float l = log(pile);
  return min(mean * (1.0f + l * (0.6815f + 0.1847f * l) / (1.0f - 0.4f * spread)), 1.0f);
}

FORMULA LobeShared lobe_shared(YarnLobes y) {
  LobeShared s;
  s.cov = safe_covariance(y.slope_cov);
  float det = s.cov.x * s.cov.z - s.cov.y * s.cov.y;
  s.inverse = vec3(s.cov.z, -s.cov.y, s.cov.x) / det;
  s.peak = 1.0f / (2.0f * kPi * sqrt(det));
  // Principal variances, for the mean albedo (it does not change when the lobe turns).
  float half_sum = 0.5f * (s.cov.x + s.cov.z);
  float half_gap = 0.5f * (s.cov.x - s.cov.z);
  float root = sqrt(half_gap * half_gap + s.cov.y * s.cov.y);
  float major = half_sum + root;
  vec2 spread = vec2(spread_coordinate(major), spread_coordinate(det / major));
  vec2 mean = albedo_mean_table(spread.x, spread.y);
  float lost = max(mean.x * half_sum / (1.0f + half_sum), 1.0e-7f);
  // Kulla, Conty 2017: facets that light meets again reflect with the mean Fresnel term. Differs: at least a
  // quarter leaves at a time, which keeps a coloured lobe of any roughness from turning black.
  vec3 f_mean = y.f0 + (y.f90 - y.f0) * pile_mean(y.pile, 1.0f / 21.0f, 0.0f);
  float stays = min(lost, 0.75f);
  s.recurring = f_mean * f_mean * (1.0f - stays) / (1.0f - f_mean * stays);
  s.multiple = s.recurring / (kPi * lost);
  float mean_rise = pile_mean(y.pile, mean.y, spread.x + spread.y);
  vec3 mean_albedo = y.f0 * (1.0f - lost) + (y.f90 - y.f0) * mean_rise + s.recurring * lost;
  s.mean_enters = max(1.0f - mean_albedo, vec3(2.0e-3f));
  s.body_scale = 1.0f / (kPi * s.mean_enters);
  return s;
}

FORMULA LobePlace lobe_place(LobeShared s, vec3 w) {
  LobePlace p;
  p.mu = max(w.z, kMinCosine);
  float sine2 = max(w.x * w.x + w.y * w.y, 1.0e-10f);
  float sigma2 = max(variance_along(s.cov, w.x, w.y), 1.0e-10f * s.cov.x);
  p.area = gaussian_area(p.mu, sqrt(sigma2));
  float along = sigma2 / sine2;
  float across = max(s.cov.x + s.cov.z - along, kMinVariance);
  p.mixed = clamp(1.0f - (s.cov.x * s.cov.z - s.cov.y * s.cov.y) / (along * across), 0.0f, 1.0f);
  p.along = spread_coordinate(along);
  p.across = spread_coordinate(across);
  p.rim = p.mu + sqrt(sine2) * p.along;
  p.opening = sqrt(p.mu / p.rim);
  return p;
}

FORMULA vec2 fuzz_place(YarnLobes y, float mu) {
  float depth = max(y.fuzz_depth, 1.0e-4f);
  return vec2(mu / (mu + depth), depth / (1.0f + depth));
}

// From what the tables hold at the place: x of `stored` the loss, y the cosine over the rim.
FORMULA LobeSide lobe_finish(YarnLobes y, LobeShared s, LobePlace p, vec2 stored, vec4 fuzz) {
  LobeSide side;
  side.mu = p.mu;
  side.area = p.area;
  side.lost = stored.x;
  float k = max(1.0f - stored.y * p.rim, 0.0f);  // of the facets that are seen
  float k2 = k * k;
  float rise = pile_over_facets(y.pile, k2 * k2 * k, p.along * p.along + p.across * p.across);
  vec3 specular = (y.f0 + (y.f90 - y.f0) * rise) * (1.0f - side.lost) + s.recurring * side.lost;
  side.enters = max(1.0f - specular, vec3(0.0f));
  side.clear = 1.0f;
  side.fuzz = fuzz;
  if (y.fuzz > 0.0f) side.clear = exp(-min(max(y.fuzz_depth, 1.0e-4f) / p.mu, 80.0f));
  return side;
}

FORMULA LobeSide lobe_side(YarnLobes y, LobeShared s, vec3 w) {
  LobePlace p = lobe_place(s, w);
  vec4 t = albedo_table(p.opening, p.along, p.across);
  vec2 f = fuzz_place(y, p.mu);
  vec4 fuzz = vec4(0.0f);
  if (y.fuzz > 0.0f) fuzz = fuzz_table(f.x, f.y);
  return lobe_finish(y, s, p, mix(vec2(t.x, t.y), vec2(t.z, t.w), p.mixed), fuzz);
}

// F D V of the facets: V = G / (4 mu_i mu_o), height-correlated (Heitz 2014, eq. 99).
FORMULA vec3 lobe_specular(YarnLobes y, LobeShared s, LobeSide i, LobeSide o, vec3 wi, vec3 wo) {
  float hx = wi.x + wo.x;
  float hy = wi.y + wo.y;
  float hz = i.mu + o.mu;
  float length2 = max(hx * hx + hy * hy + hz * hz, 1.0e-8f);
  float slope_x = hx / hz;
  float slope_y = hy / hz;
  float q = s.inverse.x * slope_x * slope_x + 2.0f * s.inverse.y * slope_x * slope_y
          + s.inverse.z * slope_y * slope_y;
  float secant2 = length2 / (hz * hz);
  float d = s.peak * exp(-0.5f * min(q, 160.0f)) * secant2 * secant2;
  float v = 0.25f / (i.area * o.mu + o.area * i.mu - i.mu * o.mu);
  float k = max(1.0f - 0.5f * sqrt(length2), 0.0f);  // 1 - wi.h
  return (y.f0 + (y.f90 - y.f0) * pile_grazing(y.pile, k)) * (d * v);
}

// Light from wi leaves along wo, both above the surface.
FORMULA vec3 lobe_reflect(YarnLobes y, LobeShared s, LobeSide i, LobeSide o, vec3 wi, vec3 wo) {
  vec3 base = lobe_specular(y, s, i, o, wi, wo) + s.multiple * (i.lost * o.lost)
            + y.body * s.body_scale * i.enters * o.enters;
  if (y.fuzz <= 0.0f) return base;
  float clear = i.clear * o.clear;
  float once = (1.0f - clear) / (4.0f * kPi * (i.mu + o.mu));
  float again = i.fuzz.y * o.fuzz.y / (kPi * max(o.fuzz.w, 1.0e-4f));
  vec3 hair = y.fuzz_colour * (vec3(once) + y.body * s.mean_enters * again);
  return base * (1.0f - y.fuzz * (1.0f - clear)) + hair * y.fuzz;
}

// Light from wi below leaves along wo above: i is the side of wi mirrored to above.
FORMULA vec3 lobe_transmit(YarnLobes y, LobeShared s, LobeSide i, LobeSide o) {
  float clear = 1.0f - y.fuzz * (1.0f - i.clear * o.clear);
  return y.through * s.body_scale * i.enters * o.enters * clear;
}

FORMULA vec3 yarn_reflect(YarnLobes y, vec3 wi, vec3 wo) {
  if (wi.z <= 0.0f || wo.z <= 0.0f) return vec3(0.0f);
  LobeShared s = lobe_shared(y);
  return lobe_reflect(y, s, lobe_side(y, s, wi), lobe_side(y, s, wo), wi, wo);
}

FORMULA vec3 yarn_transmit(YarnLobes y, vec3 wi, vec3 wo) {
  if (wi.z >= 0.0f || wo.z <= 0.0f) return vec3(0.0f);
  LobeShared s = lobe_shared(y);
  return lobe_transmit(y, s, lobe_side(y, s, vec3(wi.x, wi.y, -wi.z)), lobe_side(y, s, wo));
}

// Share of a uniform sky's light that leaves along wo (by reflection).
FORMULA vec3 lobe_albedo(YarnLobes y, LobeShared s, LobeSide o) {
  vec3 base = 1.0f - o.enters + y.body * o.enters;
  vec3 veiled = base * (o.clear * o.fuzz.z)
              + y.fuzz_colour * (vec3(o.fuzz.x) + y.body * s.mean_enters * o.fuzz.y);
  return mix(base, veiled, y.fuzz);
}

FORMULA vec3 yarn_albedo(YarnLobes y, vec3 wo) {
  LobeShared s = lobe_shared(y);
  return lobe_albedo(y, s, lobe_side(y, s, wo));
}

// A frame on the surface: t along the fibre, n the normal.
struct LobeFrame {
  vec3 t;
  vec3 b;
  vec3 n;
};

// `fibre` need not be perpendicular to n, nor of unit length.
FORMULA LobeFrame lobe_frame(vec3 n, vec3 fibre) {
  LobeFrame f;
  f.n = n;
  vec3 t = fibre - n * dot(n, fibre);
  float t2 = dot(t, t);
  vec3 other = abs(n.x) < 0.7f ? vec3(1.0f, 0.0f, 0.0f) : vec3(0.0f, 1.0f, 0.0f);
  other = other - n * dot(n, other);
  f.t = t2 > 1.0e-8f ? t * inversesqrt(max(t2, 1.0e-8f)) : normalize(other);
  f.b = cross(n, f.t);
  return f;
}

FORMULA vec3 lobe_local(LobeFrame f, vec3 w) {
  return vec3(dot(f.t, w), dot(f.b, w), dot(f.n, w));
}

// Covariance (xx, xy, yy) of slopes of the plane z = 0 about their mean, as slopes of the frame whose
// normal is that mean (first order in the deviation from it).
FORMULA vec3 lobe_covariance(LobeFrame f, vec3 cov) {
  float k = f.n.z * f.n.z;
  return vec3(variance_along(cov, f.t.x, f.t.y),
              cov.x * f.t.x * f.b.x + cov.y * (f.t.x * f.b.y + f.t.y * f.b.x) + cov.z * f.t.y * f.b.y,
              variance_along(cov, f.b.x, f.b.y)) * k;
}

// Adds the slopes of unresolved relief (covariance in the lobe's own frame).
FORMULA YarnLobes yarn_widen(YarnLobes y, vec3 cov) {
  YarnLobes wide = y;
  wide.slope_cov = y.slope_cov + cov;
  return wide;
}

// Fits a half float, whatever the lobe and however small the light.
FORMULA vec3 half_safe(vec3 v) {
  return clamp(v, vec3(0.0f), vec3(65000.0f));
}
