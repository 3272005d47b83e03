// GLSL only: the uniform blocks, the low-frequency sky, shadows of the lights, and the output encoding.

#include "interop.h"
#include "tone.glsl"

layout(std140) uniform FrameBlock { FrameData frame; };
layout(std140) uniform ClothBlock { ClothData cloth; };

uniform sampler2DShadow sun_shadow_map;
uniform sampler2DArrayShadow more_shadow_map;

// Index of the current light: 0 is the key light and the sky, others are more lights of an environment.
int light_index = 0;

vec4 current_light() { return light_index == 0 ? frame.light : frame.more_light[light_index - 1]; }
vec3 current_light_color() { return light_index == 0 ? frame.light_color.rgb : frame.more_color[light_index - 1].rgb; }
int last_light() { return int(frame.picture.w); }

// Radiance of the sky along d, blurred: `one` and `two` scale its bands 1 and 2 (1, 1: unchanged; 2/3, 1/4: as seen by
// a Lambertian surface, times pi for irradiance; Ramamoorthi, Hanrahan 2001).
vec3 sky_radiance(vec3 d, float one, float two) {
  if (light_index > 0) return vec3(0.0);
  vec3 l1 = frame.sky[1].rgb * d.y + frame.sky[2].rgb * d.z + frame.sky[3].rgb * d.x;
  vec3 l2 = (frame.sky[4].rgb * (d.x * d.y) + frame.sky[5].rgb * (d.y * d.z) + frame.sky[7].rgb * (d.x * d.z)) * 1.092548
          + frame.sky[6].rgb * (0.946176 * d.z * d.z - 0.315392 * dot(d, d))
          + frame.sky[8].rgb * (0.546274 * (d.x * d.x - d.y * d.y));
  return max(frame.sky[0].rgb * 0.282095 + l1 * (0.488603 * one) + l2 * two, vec3(0.0));
}

// Mean radiance that a Lambertian surface of normal n sees (irradiance / pi).
vec3 sky_diffuse(vec3 n) { return sky_radiance(n, 0.666667, 0.25); }

// Mean radiance of a part of the sky with mean direction d: the shorter d, the wider the part. A Lambertian surface
// has a d of length 2/3 and a factor of 1/4 for band 2, as here to within a tenth.
vec3 sky_about(vec3 d) { return sky_radiance(d, 1.0, min(length(d), 1.0)); }

// Normal offset against self-shadowing where the filter reaches past the texel: its reach on the map times the sine to
// the light; `lift` for a surface parallel to the light.
vec3 offset_from_surface(vec3 position, vec3 n, vec3 l, float lift) {
  float c = dot(n, l);
  return position + n * (lift * max(sqrt(max(1.0 - c * c, 0.0)), 0.4));
}

// Visibility of a light beside the key light.
float more_light_visibility(vec3 position, vec3 n) {
  int i = light_index - 1;
  vec3 lifted = offset_from_surface(position, n, frame.more_light[i].xyz, 2.5 * frame.more_color[i].w);
  vec3 at = (frame.world_to_more[i] * vec4(lifted, 1.0)).xyz;
  float step_uv = 1.5 / float(textureSize(more_shadow_map, 0).x);
  vec2 a = vec2(0.35, 0.93) * step_uv;
  vec2 b = vec2(-0.93, 0.35) * step_uv;
  float layer = float(i);
  return 0.25 * (texture(more_shadow_map, vec4(at.xy + a, layer, at.z)) + texture(more_shadow_map, vec4(at.xy - a, layer, at.z))
               + texture(more_shadow_map, vec4(at.xy + b, layer, at.z)) + texture(more_shadow_map, vec4(at.xy - b, layer, at.z)));
}

// Visibility of the current light: a rotated grid of taps over the shadow map, wider than its texels. n: normal of the
// visible side.
float key_visibility(vec3 position, vec3 n) {
  if (light_index > 0) return more_light_visibility(position, n);
  vec3 lifted = offset_from_surface(position, n, frame.light.xyz, frame.shadow.z);
  vec3 at = (frame.world_to_shadow * vec4(lifted, 1.0)).xyz;
  float step_uv = frame.shadow.x * frame.shadow.y;
#if SHADOW_TAPS == 4
  vec2 a = vec2(0.35, 0.93) * step_uv;
  vec2 b = vec2(-0.93, 0.35) * step_uv;
  float lit = texture(sun_shadow_map, vec3(at.xy + a * 0.8, at.z)) + texture(sun_shadow_map, vec3(at.xy - a * 0.8, at.z))
            + texture(sun_shadow_map, vec3(at.xy + b * 0.8, at.z)) + texture(sun_shadow_map, vec3(at.xy - b * 0.8, at.z));
  return lit * 0.25;
#else
  float lit = 0.0;
  for (int i = 0; i < SHADOW_TAPS; ++i) {
    float r = sqrt((float(i) + 0.5) / float(SHADOW_TAPS)) * 1.4 * step_uv;
    float t = 2.39996323 * float(i);
    lit += texture(sun_shadow_map, vec3(at.xy + r * vec2(cos(t), sin(t)), at.z));
  }
  return lit / float(SHADOW_TAPS);
#endif
}

// Encodes a scene-linear colour for the target: tone-mapped, or unchanged for an .exr.
vec4 encoded(vec3 scene, float alpha) {
  // Within the range of half floats.
  vec3 c = min(scene * frame.light_color.w, vec3(65000.0));
  return frame.picture.z > 0.5 ? vec4(c * alpha, alpha) : vec4(tone_map(c) * alpha, alpha);
}
