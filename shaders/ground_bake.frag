// Fraction of its light that reaches each point of the ground: the key light with a penumbra that widens with the
// height of the occluder, and the sky by the map of sky visibility.
//
// Based on: Fernando 2005, "Percentage-closer soft shadows".
#include "frame.glsl"

uniform sampler2D ground_map;
uniform sampler2D sun_depth_map;

in vec2 at;
out vec4 out_color;

const vec3 kGround = vec3(0.0, 1.0, 0.0);
const int kTaps = 40;
const float kDarkest = 0.66;   // a studio floor also gets indirect light

vec2 spiral(int i) {
  float t = 2.39996323 * float(i);
  return sqrt((float(i) + 0.5) / float(kTaps)) * vec2(cos(t), sin(t));
}

// How deep the map is over how wide it is, in millimetres.
float depth_over_side() {
  mat3 map = transpose(mat3(frame.world_to_shadow));
  return length(map[0]) / length(map[2]);
}

float key_light_visibility(vec3 p) {
  vec3 here = (frame.world_to_shadow * vec4(p, 1.0)).xyz;
  float width = frame.light.w * depth_over_side();  // of the penumbra on the map, for one of its depth
  float reach = 2.2 * width;
  if (abs(here.x - 0.5) > 0.5 + reach || abs(here.y - 0.5) > 0.5 + reach) return 1.0;
  here.z = min(here.z, 0.998);  // the ground extends beyond the depth range of the map
  float depth = 0.0;
  float blockers = 0.0;
  for (int i = 0; i < kTaps; ++i) {
    float d = texture(sun_depth_map, here.xy + spiral(i) * reach * 0.35).r;
    if (d < here.z - 0.002) {
      depth += d;
      blockers += 1.0;
    }
  }
  if (blockers < 0.5) return 1.0;
  float radius = max((here.z - depth / blockers) * width, 1.5 * frame.shadow.x);
  float lit = 0.0;
  for (int i = 0; i < kTaps; ++i) lit += step(here.z - 0.002, texture(sun_depth_map, here.xy + spiral(i) * radius).r);
  return lit / float(kTaps);
}

void main() {
  vec3 p = vec3(frame.ground.z + at.x * frame.ground.y, frame.ground.x, frame.ground.w + at.y * frame.ground.y);
  float sky = texture(ground_map, at * 0.5 + 0.5).r;
  float key = max(frame.light.y, 0.0) * dot(frame.light_color.rgb, vec3(0.3333)) / 3.14159265;
  float diffuse = dot(sky_diffuse(kGround), vec3(0.3333));
  float lit = 1.0 - frame.shadow.w * (1.0 - key_light_visibility(p));
  float left = (key * lit + diffuse * sky) / max(key + diffuse, 1e-4);
  out_color = vec4(1.0 - (1.0 - left) * kDarkest);
}
