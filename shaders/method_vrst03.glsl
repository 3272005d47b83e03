// Method `vrst03`: thread texture times the average BRDF from two cube maps times the boolean shadow map of the
// nearest of a few light directions.
//
// Based on: Adabala, Magnenat-Thalmann, Fei 2003, "Real-time rendering of woven clothes", section 3; Kautz, McCool
// 1999, "Interactive rendering with arbitrary BRDFs using separable approximations".
// Differs: the texture is divided by its mean, since the BRDF contains the threads' colours already; the sky, which
// the paper does not have, lights the texture alone.

#include "vrst03.glsl"

uniform sampler2DArray thread_shadow_map;
uniform samplerCube front_half_map;
uniform samplerCube front_difference_map;
uniform samplerCube back_half_map;
uniform samplerCube back_difference_map;

vec3 separable_brdf(int face, vec3 wi, vec3 wo) {
  if (wi.z <= 0.0 || wo.z <= 0.0) return vec3(0.0);
  vec3 h = normalize(wi + wo);
  vec3 d = vrst03_difference(wi, wo);
  return face == 0 ? texture(front_half_map, h).rgb * texture(front_difference_map, d).rgb
                   : texture(back_half_map, h).rgb * texture(back_difference_map, d).rgb;
}

float thread_shadow(int face, vec3 l) {
  float around = floor(atan(l.y, l.x) * 0.15915494 * float(SHADOW_AZIMUTHS) + 0.5);
  float azimuth = mod(around, float(SHADOW_AZIMUTHS));
  float elevation = asin(clamp(l.z, 0.0, 1.0));
  float level = elevation < 0.55 ? 0.0 : elevation < 0.95 ? 1.0 : 2.0;  // nearest of 0.35, 0.75, 1.15
  float layer = (float(face) * 3.0 + level) * float(SHADOW_AZIMUTHS) + azimuth;
  return texture(thread_shadow_map, vec3(tile, layer)).r;
}

vec4 shade_vrst03(Side side, Lights x, Footprint f) {
  vec3 color = thread_color(side, fetch_color(side, f, 0), fetch_color(side, f, 1));
  SystemData a = cloth.systems[side.face * 2];
  SystemData b = cloth.systems[side.face * 2 + 1];
  vec3 mean = (a.color.rgb * a.coverage + b.color.rgb * b.coverage) / max(a.coverage + b.coverage, 1e-3);
  // What is dark in all threads is as dark as its mean: few steps of the maps' eight bits tell how dark.
  vec3 brdf = separable_brdf(side.face, x.l, x.v) * ((color + 0.002) / (mean + 0.002));
  vec3 light = x.key * brdf * (max(x.l.z, 0.0) * thread_shadow(side.face, x.l)) + color * sky_diffuse(side.n) * side.sky;
  return vec4(light, cover_of(side, x, f));
}
