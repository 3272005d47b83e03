// Shading of the methods from what was fetched: radiance towards the eye for unit irradiance of the key light at
// normal incidence, and reflected fractions of the sky. GLSL 3.30 and C++20.
// Frame: x along the weft, y along the warp, z the cloth's normal on the visible side.
//
//   yarn    facet_radiance() of the thread on top
//   cell    facet_radiance() of each system's mean facet, widened by the spread of its normals;
//           key_far_field() for light from behind
//   repeat  system_radiance() of each system, corrected by the local facets, weighted by colour and coverage:
//           mixed_radiance()
//   cloth   system_radiance() of each system with the means of the period
//   engine  engine_radiance() of the averaged normal (engine.glsl)
//
// Based on: Dupuy et al. 2013 (moments of slopes); Westin, Arvo, Torrance 1992 (a table measured on small geometry);
// Ashikhmin, Premoze, Shirley 2000 (facets that mirror, by their normals).

#include "interop.h"

#ifndef FORMULA
#define FORMULA
#endif

struct Reflected {
  vec3 key;      // radiance for unit irradiance of the key light at normal incidence
  vec3 diffuse;  // diffusely reflected fraction of the sky's light
  vec3 glossy;   // mirrored fraction of the sky's light
};

// Lobes of a yarn, or of a mean of yarns, on a thread of this colour.
FORMULA YarnLobes yarn_of(YarnData data, vec3 color) {
  YarnLobes y;
  vec3 body = color * data.body;
  y.slope_cov = vec3(data.along_width * data.along_width, 0.0f, data.across_width * data.across_width);
  y.f90 = data.specular;
  y.fibre_layers = data.fibre_layers;
  // Half the path through the dye gives the square root of its colour, twice the path the square; interpolated
  // between.
  vec3 root = sqrt(color);
  vec3 inner = color + max(data.inner_halvings, 0.0f) * (root - color) + min(data.inner_halvings, 0.0f) * (color - color * color);
  y.f0 = vec3(data.tint) * data.specular * mix(vec3(data.reflectance), inner, data.tint.w);
  y.body = body * (1.0f - data.transmission);
  y.through = body * data.transmission;
  y.fuzz_colour = root;   // light leaves a single fibre after less absorption
  y.fuzz = data.fuzz;
  y.fuzz_depth = data.fuzz_depth;
  return y;
}

// The lobes without the slopes of fibres that are seen one by one; resolved, relief: fibre_detail.glsl.
FORMULA YarnLobes detail_lobes(YarnLobes y, vec2 resolved, float relief) {
  YarnLobes narrow = y;
  vec2 cov = vec2(y.slope_cov.x, y.slope_cov.z);
  vec2 left = max(cov - resolved * relief * relief, cov * 0.2f);
  narrow.slope_cov = vec3(left.x, y.slope_cov.y, left.y);
  return narrow;
}

// Under a uniform sky.
FORMULA Reflected facet_sky(YarnLobes y, LobeShared s, LobeSide o) {
  Reflected a;
  a.key = vec3(0.0f);
  a.glossy = max(vec3(1.0f) - o.enters, vec3(0.0f));
  a.diffuse = max(lobe_albedo(y, s, o) - a.glossy, vec3(0.0f));
  return a;
}

// Sky visibility of a facet with normal n among the surrounding threads, as a diffuse surface weights it, and the mean
// direction of the visible sky. Fitted to threads of all kinds: what n turns away from is hidden.
FORMULA float facet_sky_visibility(vec3 n) { return clamp(0.12f + 0.88f * n.z, 0.0f, 1.0f); }
FORMULA vec3 facet_sky_direction(vec3 n) { return vec3(0.5f * n.x, 0.5f * n.y, 0.67f); }

// The same for light mirrored from around direction r.
FORMULA float mirrored_sky_visibility(vec3 r) {
  float x = 0.5f + 0.5f * r.z;
  return x * x * (3.0f - 2.0f * x);
}
FORMULA vec3 mirrored_sky_direction(vec3 r) { return vec3(0.55f * r.x, 0.55f * r.y, 0.6f + 0.1f * r.z); }

// Facets with mean normal n whose fibres run along `fibre`; cov: covariance of the unresolved slopes about n;
// mean_length: length of their mean normal, by which they receive less light than one facet.
FORMULA Reflected facet_radiance(YarnLobes yarn, vec3 n, float mean_length, vec3 fibre, vec3 cov, vec3 l, vec3 v) {
  LobeFrame f = lobe_frame(n, fibre);
  YarnLobes y = yarn_widen(yarn, lobe_covariance(f, cov));
  LobeShared s = lobe_shared(y);
  vec3 wo = lobe_local(f, v);
  wo = normalize(vec3(wo.x, wo.y, max(wo.z, 0.02f)));
  vec3 wi = lobe_local(f, l);
  LobeSide o = lobe_side(y, s, wo);
  LobeSide i = lobe_side(y, s, vec3(wi.x, wi.y, max(abs(wi.z), 1.0e-3f)));
  Reflected a = facet_sky(y, s, o);
  a.key = wi.z > 0.0f ? lobe_reflect(y, s, i, o, wi, wo) : lobe_transmit(y, s, i, o);
  a.key *= abs(wi.z) * mean_length;
  return a;
}

// Coordinates of a direction in the response tables: azimuth 0..1 (wraps), elevation in nodes.
FORMULA vec2 response_coord(vec3 w) {
  float turn = atan(w.y, w.x) * 0.15915494f;
  return vec2(turn - floor(turn), sqrt(clamp(abs(w.z), 0.0f, 1.0f)) * float(RESPONSE_ELEVATIONS - 1));
}

// The same for light from behind, in its tables.
FORMULA vec2 transmission_coord(vec3 l) {
  float turn = atan(l.y, l.x) * 0.15915494f;
  return vec2(turn - floor(turn), sqrt(clamp(1.0f - abs(l.z), 0.0f, 1.0f)) * float(TRANSMISSION_ELEVATIONS - 1));
}

// Coordinate 0..1 of a slope in the tables of slopes.
FORMULA float slope_coord(float slope) { return atan(slope) * 0.31830989f + 0.5f; }

// Slopes of the half vector along x and y.
FORMULA vec2 half_slopes(vec3 l, vec3 v) {
  float z = max(l.z + v.z, 1.0e-3f);
  return vec2((l.x + v.x) / z, (l.y + v.y) / z);
}

// Density of normals (1/sr) of facets with slopes h; slopes: density of the angles of h.x and h.y.
FORMULA float facet_density(float slopes, vec2 h) {
  float secant2 = 1.0f + h.x * h.x + h.y * h.y;
  return slopes / ((1.0f + h.x * h.x) * (1.0f + h.y * h.y)) * secant2 * secant2;
}

// Added to the density of facets wherever mirrored light is divided by it, so that light which few facets mirror stays
// finite.
const float kFacetDensityFloor = 0.01f;

// Mirrored light in the response tables: its logarithm. From node to node highlights rise and fall by factors, and half
// way between two of them is their geometric mean; the floor keeps what is next to nothing from darkening a neighbour.
const float kMirrorFloor = 1.0e-3f;
FORMULA float stored_mirror(float mirror) { return log2(mirror + kMirrorFloor); }
FORMULA float mirror_of(float stored) { return max(exp2(stored) - kMirrorFloor, 0.0f); }

// Schlick's (1 - cosine)^5 averaged over a hemisphere, and the Fresnel term with it: the colour of multiple scattering.
const float kMeanGrazing = 1.0f / 21.0f;
FORMULA vec3 mean_fresnel(YarnLobes y) { return y.f0 + (y.f90 - y.f0) * kMeanGrazing; }

// What a thread reflects of a uniform sky that nothing hides, nearly.
FORMULA vec3 unhidden_reflectance(YarnLobes y) { return y.body + mean_fresnel(y); }

// Light that threads send to each other. A yarn's colour is that of its cloth, as a weaver sees it and a photograph
// measures it: it includes light that has met several threads. Where grooves and faces are told apart, one reflection is
// a little less than that colour, and what threads around send is added:
//
//   radiance of a place = alone * (direct light + reflected light of hidden directions)
//   alone = reflected_alone(mean fraction that places reflect of hidden directions, seen from straight above)
//
// so that the mean over all places is the response without either (core/light/cloth_response.h); at a slant, where one sees
// less of the grooves and what they send, a light cloth is darker by up to a tenth, as traced; the response knows that, too.
// Based on: Koenderink, van Doorn 1983 (interreflection in a uniform concavity).
// Differs: directions that are hidden show one radiance, that of a few yarns around.

// Radiance of what a place sees of other threads over the mean of the cloth: the walls of a groove lie in shadow, too. So
// chosen that traced cloths are about as bright on the mean with reflections between threads as without.
const float kGrooveLight = 0.85f;

FORMULA vec3 reflected_alone(vec3 hidden) { return 1.0f / (1.0f + kGrooveLight * hidden); }

// The key light in system_radiance(); mirrors: density of the facets that mirror it, 1 for light from behind.
FORMULA vec3 key_far_field(YarnLobes y, vec4 reflected, float mirrors, vec3 l, vec3 v) {
  vec3 sum = l + v;
  float length2 = max(dot(sum, sum), 1.0e-6f);
  float k = max(1.0f - 0.5f * sqrt(length2), 0.0f);
  vec3 fresnel = y.f0 + (y.f90 - y.f0) * layered_grazing(y.fibre_layers, k);
  vec3 body = l.z > 0.0f ? y.body : y.body + y.through;
  return body * reflected.x + fresnel * (mirrors * reflected.y) + y.fuzz_colour * reflected.z + mean_fresnel(y) * reflected.w;
}

// One thread system in the far field. reflected: its response (core/light/cloth_response.h), `transmitted` there for
// light from behind; slopes: density of the slope angles at half_slopes(); fraction: of the coverage at normal view;
// sky: its response to a uniform sky.
FORMULA Reflected system_radiance(YarnLobes y, vec4 reflected, float slopes, float fraction, vec4 sky, vec3 l, vec3 v) {
  float mirrors = l.z > 0.0f ? facet_density(slopes, half_slopes(l, v)) * fraction + kFacetDensityFloor : 1.0f;
  Reflected a;
  a.key = key_far_field(y, reflected, mirrors, l, v);
  a.diffuse = y.body * sky.x + y.fuzz_colour * sky.y;
  a.glossy = y.f0 * (sky.z - sky.w) + y.f90 * sky.w;
  return a;
}

// Local factor on the mean radiance from the facets there; gradient: measured by moment.
FORMULA float gradient_factor(vec4 gradient, vec4 facets, vec4 mean_facets) {
  return max(1.0f + dot(gradient, facets - mean_facets), 0.0f);
}

// Visible fraction of a system where the cloth around has `region` times its mean coverage, over that coverage. rise:
// measured change of the visible fraction with that coverage, minus 1: the fewer threads lie in the valleys between
// the others. Weighted by `region` it is linear, so that means stay.
FORMULA float region_factor(float rise, float region) {
  return max(1.0f + rise * (1.0f - 1.0f / max(region, 0.2f)), 0.0f);
}

// Both systems, weighted by their local coverage over the mean (relative) and their visible fraction (seen).
FORMULA Reflected mixed_radiance(Reflected warp, Reflected weft, vec2 relative, vec2 seen) {
  float scale = 1.0f / max(relative.x * seen.x + relative.y * seen.y, 1.0e-4f);
  Reflected a;
  a.key = (warp.key * relative.x + weft.key * relative.y) * scale;
  a.diffuse = (warp.diffuse * relative.x + weft.diffuse * relative.y) * scale;
  a.glossy = (warp.glossy * relative.x + weft.glossy * relative.y) * scale;
  return a;
}
