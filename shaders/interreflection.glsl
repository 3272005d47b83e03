// Light that threads around a pixel send to it (methods.glsl has the model): their radiance by the far-field response of
// each system, in the colours of a few yarns around.

#include "method_repeat.glsl"

const float kYarnsAround = 4.0;

struct Interreflection {
  vec3 radiance;  // of the threads around
  vec3 alone;
  vec2 weight;    // by system, of what a place reflects of hidden directions times its visible fraction of the sky
};

Interreflection interreflection(Side side, Lights x, Footprint f) {
  float level = max(f.level, log2(kYarnsAround * float(textureSize(color_map, 0).x) * cloth.spacing_mm / cloth.width_mm));
  VisibleSystems seen = visible_systems(side.face, x.v);
  // A thread reflects the same wherever it is seen from: its colour is that of the cloth seen from straight above.
  vec3 above = vec3(0.0, 0.0, 1.0);
  vec2 seen_above = visible_systems(side.face, above).fraction;
  vec2 hidden_above = view_table(side.face, 5, above).xy;
  vec2 slopes = half_slope_coords(x);
  Reflected of[2];
  vec3 sent[2];
  vec2 relative;
  for (int which = 0; which < 2; ++which) {
    int system = side.face * 2 + which;
    SystemData data = cloth.systems[system];
    vec4 color = textureLod(color_map, vec3(f.at, float(system)), level);
    vec3 own = system_color(color, data);
    relative[which] = color.a / max(data.coverage, 1.0e-3);
    of[which] = far_field_of(side, x, which, slopes, own);
    sent[which] = unhidden_reflectance(yarn_of(data.yarn, own)) * (hidden_above[which] * relative[which]);
  }
  float scale = 1.0 / max(dot(relative, seen_above), 1.0e-4);
  Interreflection a;
  a.radiance = kGrooveLight * mixed_light(side, x, mixed_radiance(of[0], of[1], relative, seen.fraction));
  a.alone = reflected_alone((sent[0] + sent[1]) * scale);
  a.weight = 1.0 / view_table(side.face, 5, x.v).zw;
  return a;
}
