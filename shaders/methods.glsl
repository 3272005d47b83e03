// What a rung of the ladder makes of what was fetched for it: radiance towards the eye for a unit of the key
// light's irradiance at right angles, and shares of the sky's light. GLSL 3.30 and C++20.
// Frame: x along the weft, y along the warp, z the cloth's normal on the side that is seen.
//
//   yarn    facet_answer() of the thread on top
//   cell    facet_answer() of each system's mean facet, widened by the spread of its normals; key_far_field() from behind
//   repeat  system_answer() of each system, leaned with the facets at the place, by colour and share: mixed_answer()
//   cloth   system_answer() of each system with the means of the period
//   engine  engine_answer() of the averaged normal (engine.glsl)
//
// Based on: Dupuy et al. 2013 (moments of slopes); Westin, Arvo, Torrance 1992 (a table measured on small
//   geometry); Ashikhmin, Premoze, Shirley 2000 (facets that mirror, by their normals).

#include "interop.h"

#ifndef FORMULA
#define FORMULA
#endif

struct Answer {
  vec3 key;      // for a unit of the key light's irradiance at right angles
  vec3 soft;     // share of the sky's diffuse light
  vec3 glossy;   // share of the sky as it is mirrored
};

// Lobes of a yarn, or of a mean of yarns, on a thread of that colour.
FORMULA YarnLobes yarn_of(YarnData data, vec3 color) {
  YarnLobes y;
  vec3 body = color * data.body;
  y.slope_cov = vec3(data.along_width * data.along_width, 0.0f, data.across_width * data.across_width);
  y.f90 = data.specular;
  y.pile = data.pile;
  // Half the way through the dye: the root of its colour; twice: the square. Between, in proportion.
  vec3 root = sqrt(color);
  vec3 inner = color + max(data.inner_pale, 0.0f) * (root - color) + min(data.inner_pale, 0.0f) * (color - color * color);
  y.f0 = vec3(data.tint) * data.specular * mix(vec3(data.reflectance), inner, data.tint.w);
  y.body = body * (1.0f - data.transmission);
  y.through = body * data.transmission;
  y.fuzz_colour = root;   // light leaves a lone fibre after fewer meetings with the dye
  y.fuzz = data.fuzz;
  y.fuzz_depth = data.fuzz_depth;
  return y;
}

// Of an even sky all around.
FORMULA Answer facet_sky(YarnLobes y, LobeShared s, LobeSide o) {
  Answer a;
  a.key = vec3(0.0f);
  a.glossy = max(vec3(1.0f) - o.enters, vec3(0.0f));
  a.soft = max(lobe_albedo(y, s, o) - a.glossy, vec3(0.0f));
  return a;
}

// Share of the sky, as a body sees it, that the threads around leave to a facet of normal n of a thread, and the mean
// direction of it. Measured on threads of all kinds: what n leans away from above is hidden, wherever it lies.
FORMULA float facet_seen(vec3 n) { return clamp(0.12f + 0.88f * n.z, 0.0f, 1.0f); }
FORMULA vec3 facet_seen_from(vec3 n) { return vec3(0.5f * n.x, 0.5f * n.y, 0.67f); }

// The same of what is mirrored from around the direction r.
FORMULA float mirrored_seen(vec3 r) {
  float x = 0.5f + 0.5f * r.z;
  return x * x * (3.0f - 2.0f * x);
}
FORMULA vec3 mirrored_seen_from(vec3 r) { return vec3(0.55f * r.x, 0.55f * r.y, 0.6f + 0.1f * r.z); }

// Facets of mean normal n whose fibres run along `fibre`; cov: covariance of the unresolved slopes about n;
// gather: length of the mean of their unit normals, by which they catch less light than one facet.
FORMULA Answer facet_answer(YarnLobes yarn, vec3 n, float gather, vec3 fibre, vec3 cov, vec3 l, vec3 v) {
  LobeFrame f = lobe_frame(n, fibre);
  YarnLobes y = yarn_widen(yarn, lobe_covariance(f, cov));
  LobeShared s = lobe_shared(y);
  vec3 wo = lobe_local(f, v);
  wo = normalize(vec3(wo.x, wo.y, max(wo.z, 0.02f)));
  vec3 wi = lobe_local(f, l);
  LobeSide o = lobe_side(y, s, wo);
  LobeSide i = lobe_side(y, s, vec3(wi.x, wi.y, max(abs(wi.z), 1.0e-3f)));
  Answer a = facet_sky(y, s, o);
  a.key = wi.z > 0.0f ? lobe_reflect(y, s, i, o, wi, wo) : lobe_transmit(y, s, i, o);
  a.key *= abs(wi.z) * gather;
  return a;
}

// Coordinates of a direction in the response tables: azimuth 0..1 (wraps), elevation in nodes.
FORMULA vec2 response_coord(vec3 w) {
  float turn = atan(w.y, w.x) * 0.15915494f;
  return vec2(turn - floor(turn), sqrt(clamp(abs(w.z), 0.0f, 1.0f)) * float(RESPONSE_ELEVATIONS - 1));
}

// The same of light from behind, in the tables of such.
FORMULA vec2 transmission_coord(vec3 l) {
  float turn = atan(l.y, l.x) * 0.15915494f;
  return vec2(turn - floor(turn), sqrt(clamp(1.0f - abs(l.z), 0.0f, 1.0f)) * float(BEHIND_ELEVATIONS - 1));
}

// Coordinate 0..1 of a slope in the tables of slopes.
FORMULA float slope_coord(float slope) { return atan(slope) * 0.31830989f + 0.5f; }

// Half vector's slopes along x and y.
FORMULA vec2 half_slopes(vec3 l, vec3 v) {
  float z = max(l.z + v.z, 1.0e-3f);
  return vec2((l.x + v.x) / z, (l.y + v.y) / z);
}

// Density of normals (1/sr) of facets whose slopes are h; slopes: densities of the angles of h.x and h.y.
FORMULA float facet_density(vec2 slopes, vec2 h) {
  float secant2 = 1.0f + h.x * h.x + h.y * h.y;
  return slopes.x * slopes.y / ((1.0f + h.x * h.x) * (1.0f + h.y * h.y)) * secant2 * secant2;
}

// Density of facets that is added to that of a system wherever what it mirrors is held over it, or no number would tell
// of light that few facets mirror.
const float kUnseenFacets = 0.01f;

// Schlick's (1 - cosine)^5 over a hemisphere, and Fresnel's term with it: by that light is coloured which facets scatter
// more than once.
const float kMeanGrazing = 1.0f / 21.0f;
FORMULA vec3 mean_fresnel(YarnLobes y) { return y.f0 + (y.f90 - y.f0) * kMeanGrazing; }

// What system_answer() makes of the key light; mirrors: density of the facets that mirror it, 1 of light from behind.
FORMULA vec3 key_far_field(YarnLobes y, vec4 broad, float mirrors, vec3 l, vec3 v) {
  vec3 sum = l + v;
  float length2 = max(dot(sum, sum), 1.0e-6f);
  float k = max(1.0f - 0.5f * sqrt(length2), 0.0f);
  vec3 fresnel = y.f0 + (y.f90 - y.f0) * pile_grazing(y.pile, k);
  vec3 body = l.z > 0.0f ? y.body : y.body + y.through;
  return body * broad.x + fresnel * (mirrors * broad.y) + y.fuzz_colour * broad.z + mean_fresnel(y) * broad.w;
}

// One system of threads from afar. broad: its response (core/light/cloth_response.h); of light from behind
// `behind` there; slopes: densities of the slope angles at half_slopes(); share: of the cover at normal
// view; sky: its response to an even sky.
FORMULA Answer system_answer(YarnLobes y, vec4 broad, vec2 slopes, float share, vec4 sky, vec3 l, vec3 v) {
  float mirrors = l.z > 0.0f ? facet_density(slopes, half_slopes(l, v)) * share + kUnseenFacets : 1.0f;
  Answer a;
  a.key = key_far_field(y, broad, mirrors, l, v);
  a.soft = y.body * sky.x + y.fuzz_colour * sky.y;
  a.glossy = y.f0 * (sky.z - sky.w) + y.f90 * sky.w;
  return a;
}

// How much more than the mean a place sends: `lean` is the measured rise with each moment of its facets.
FORMULA float lean_factor(vec4 lean, vec4 facets, vec4 mean_facets) {
  return max(1.0f + dot(lean, facets - mean_facets), 0.0f);
}

// What is seen of a system where the cloth around shows `region` times its mean cover, over that cover: `rise` is
// measured, of the share of what is seen with that cover, less 1. The fewer threads lie in the dips between the others.
// Weighed by `region` it is linear, so that no mean changes.
FORMULA float region_factor(float rise, float region) {
  return max(1.0f + rise * (1.0f - 1.0f / max(region, 0.2f)), 0.0f);
}

// Both systems, each with its local share of the cover over its mean (relative).
FORMULA Answer mixed_answer(Answer warp, Answer weft, vec2 relative, vec2 seen) {
  float scale = 1.0f / max(relative.x * seen.x + relative.y * seen.y, 1.0e-4f);
  Answer a;
  a.key = (warp.key * relative.x + weft.key * relative.y) * scale;
  a.soft = (warp.soft * relative.x + weft.soft * relative.y) * scale;
  a.glossy = (warp.glossy * relative.x + weft.glossy * relative.y) * scale;
  return a;
}
