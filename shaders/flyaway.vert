// One flyaway fibre an instance: a strip that faces the eye, bent along an arc with a wave, in the colour of the yarn
// beneath. A fibre finer than the samples of a pixel is drawn wider and proportionally fainter, so that the mean
// stays.
#include "frame.glsl"
#include "flyaway.glsl"

uniform sampler2DArray color_map;

in vec3 in_position;   // root
in vec3 in_normal;     // of the cloth, on the fibre's side
in vec2 in_uv_mm;
in vec2 in_sky;      // x: sky visibility on its side; y: +1 the mesh's front
in vec4 in_flyaway;  // x: seed, 0..1; y: fibres that it represents; z: minimum length, mm; w: radius of the silhouette, mm

out vec4 strip_color;

const float kMinWidth = 0.85;     // pixels
const float kCrowdWidth = 2.6;    // pixels, of a strip that stands for a crowd of fibres: faint, or it would be a dot

// Based on: O'Neill 2014, "PCG".
float random(inout uint state) {
  state = state * 747796405u + 2891336453u;
  uint word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
  return float(((word >> 22u) ^ word) >> 8u) / 16777216.0;
}

vec3 any_tangent(vec3 n) { return normalize(cross(n, abs(n.y) < 0.8 ? vec3(0.0, 1.0, 0.0) : vec3(1.0, 0.0, 0.0))); }

struct Fibre {
  vec3 at;      // from its root
  vec3 along;
};

Fibre fibre_at(float t, vec3 n, float mean_length, float least_length, inout uint state) {
  // Exponentially distributed lengths beyond the minimum have the same distribution.
  float len = least_length - log(1.0 - 0.985 * random(state)) * 1.07 * mean_length;
  float z = mix(0.05, 1.0, random(state));
  float turn = 6.2831853 * random(state);
  vec3 x = any_tangent(n);
  vec3 y = cross(n, x);
  vec3 start = n * z + (x * cos(turn) + y * sin(turn)) * sqrt(1.0 - z * z);
  float roll = 6.2831853 * random(state);
  vec3 a = any_tangent(start);
  vec3 b = cross(start, a);
  vec3 side = a * cos(roll) + b * sin(roll);
  vec3 across = cross(start, side);
  float bend = mix(0.8, 3.4, random(state));
  float pace = mix(4.0, 9.0, random(state));
  float phase = 6.2831853 * random(state);
  float wave = 0.7 / pace;
  float angle = bend * t;
  Fibre f;
  f.at = (start * sin(angle) + side * (1.0 - cos(angle))) / bend + across * (wave * (sin(pace * t + phase) - sin(phase)));
  f.at *= len;
  f.along = normalize(start * cos(angle) + side * sin(angle) + across * (wave * pace * cos(pace * t + phase)));
  return f;
}

// Colour of the yarn under the root, and the albedo of the cloth there.
vec3 dye_beneath(int face, vec2 tile, out vec3 body) {
  float level = max(log2(float(textureSize(color_map, 0).x) * cloth.spacing_mm / cloth.width_mm) - 1.0, 0.0);
  vec3 sum = vec3(0.0);
  vec3 reflected = vec3(0.0);
  float weight = 0.0;
  float cover = 0.0;
  for (int i = 0; i < 2; ++i) {
    SystemData data = cloth.systems[face * 2 + i];
    vec4 c = textureLod(color_map, vec3(tile, float(face * 2 + i)), level) + vec4(data.color.rgb, 1.0) * (0.004 * data.fraction);
    float fraction = flyaway_fraction(data.yarn.fuzz);
    sum += c.rgb * fraction;
    weight += c.a * fraction;
    reflected += c.rgb * (data.yarn.body * (1.0 - data.yarn.tint.w));
    cover += c.a;
  }
  body = clamp(reflected / max(cover, 1e-4), 0.0, 1.0);
  return clamp(sum / max(weight, 1e-6), 0.0, 1.0);
}

void main() {
  uint state = floatBitsToUint(in_flyaway.x + 1.0);
  random(state);
  int step_at = gl_VertexID / 2;
  float t = float(step_at) / frame.flyaway.x;
  int face = in_sky.y * frame.eye.w > 0.0 ? 0 : 1;
  vec3 n = normalize(in_normal);
  Fibre f = fibre_at(t, n, in_sky.y > 0.0 ? frame.flyaway.z : frame.flyaway.w, in_flyaway.z, state);
  vec3 p = in_position + f.at;

  vec4 clip = frame.world_to_clip * vec4(p, 1.0);
  vec4 slope = frame.world_to_clip * vec4(f.along, 0.0);
  vec2 on_screen = (slope.xy * clip.w - clip.xy * slope.w) * frame.picture.xy;
  vec2 across = dot(on_screen, on_screen) > 1e-20 ? normalize(vec2(-on_screen.y, on_screen.x)) : vec2(1.0, 0.0);
  vec3 row = vec3(frame.world_to_clip[0][1], frame.world_to_clip[1][1], frame.world_to_clip[2][1]);
  float pixel_mm = 2.0 * clip.w / (frame.picture.y * length(row));
  float pixels = kFlyawayWidth * in_flyaway.y / max(pixel_mm, 1e-9);
  float edge = (gl_VertexID & 1) == 0 ? -1.0 : 1.0;
  float drawn = max(pixels, mix(kMinWidth, kCrowdWidth, clamp((in_flyaway.y - 1.0) / 8.0, 0.0, 1.0)));
  clip.xy += across * (edge * drawn * clip.w) / frame.picture.xy;
  // Against its own cloth a fibre is part of the fuzz lobe, so it is drawn only where the background is further away
  // than the edge of the silhouette.
  vec3 v = normalize(frame.eye.xyz - p);
  float rim = sqrt(2.0 * in_flyaway.w * (in_flyaway.z + (in_sky.y > 0.0 ? frame.flyaway.z : frame.flyaway.w)));
  vec4 back = frame.world_to_clip * vec4(p - v * rim, 1.0);
  gl_Position = vec4(clip.xy, back.z / max(back.w, 1e-6) * clip.w, clip.w);

  vec3 body;
  vec3 colour = sqrt(dye_beneath(face, in_uv_mm * frame.tile.xy + frame.tile.zw, body));
  vec3 light = flyaway_sky(colour, body) * sky_diffuse(n) * in_sky.x;
  for (light_index = 0; light_index <= last_light(); ++light_index)
    light += flyaway_key(colour, body, f.along, n, current_light().xyz, v) * current_light_color()
           * key_visibility(in_position + n * (0.5 * length(f.at)), n);
  const float kRootShade = 0.7;  // roots are shaded by the other fibres
  const float kTip = 0.5;        // width of the tip over that of the root
  strip_color = encoded(light * mix(kRootShade, 1.0, t), pixels / drawn * mix(1.0, kTip, t));
}
