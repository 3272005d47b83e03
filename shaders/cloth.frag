// The cloth, by rung: METHOD_FLAT, METHOD_VRST03 or METHOD_YARN.
#include "frame.glsl"
#include "horizon.glsl"
#include "filter.glsl"

uniform sampler2DArray color_map;
uniform sampler2DArray relief_map;
uniform sampler2DArray horizon_map;

in vec3 position;
in vec3 normal;
in vec3 tangent;
in vec2 tile;
in vec2 sky_seen;
out vec4 out_color;

// The cloth's frame at this pixel, on the side that is seen: t along the weft, b along the warp, n to the eye.
struct Side {
  vec3 t;
  vec3 b;
  vec3 n;
  int face;     // 0: the cloth's front
  float sky;    // share of the sky that the folds leave
};

Side seen_side() {
  Side s;
  float turn = gl_FrontFacing ? 1.0 : -1.0;
  vec3 n = normalize(normal);
  s.t = normalize(tangent - n * dot(n, tangent));
  s.b = cross(n, s.t);
  s.n = n * turn;
  s.face = turn * frame.eye.w > 0.0 ? 0 : 1;
  s.sky = gl_FrontFacing ? sky_seen.x : sky_seen.y;
  return s;
}

vec3 to_side(Side s, vec3 w) { return vec3(dot(s.t, w), dot(s.b, w), dot(s.n, w)); }
vec3 from_side(Side s, vec3 w) { return s.t * w.x + s.b * w.y + s.n * w.z; }

// One thread system of the footprint.
struct System {
  vec4 color;     // premultiplied by coverage
  vec3 n;         // mean normal
  vec2 variance;  // of the unit normal's x and y
};

System fetch_system(Side s, int which) {
  float layer = float(s.face * 2 + which);
  System y;
  y.color = texture(color_map, vec3(tile, layer));
  vec4 r = texture(relief_map, vec3(tile, layer)) / max(y.color.a, 0.02);
  float across = min(dot(r, r), 0.98);
  y.n = vec3(r.xy, sqrt(1.0 - across));
  y.variance = r.zw * r.zw;
  return y;
}

// Share of the key light that the threads leave, and of the sky.
vec2 thread_light(Side s, vec3 l) {
  int count = int(cloth.size.w);
  float base = float(s.face * (count + 1));
  float turn = atan(l.y, l.x) * 0.15915494 * float(count);
  float bin = floor(turn);
  float k = mod(bin, float(count));
  float k2 = mod(bin + 1.0, float(count));
  vec2 h = mix(texture(horizon_map, vec3(tile, base + k)).rg, texture(horizon_map, vec3(tile, base + k2)).rg, turn - bin);
  float occlusion = texture(horizon_map, vec3(tile, base + float(count))).r;
  return vec2(horizon_visibility(l.z, h.x, 0.5 * h.y, frame.light.w), occlusion);
}

void main() {
  Side side = seen_side();
  vec3 l = to_side(side, frame.light.xyz);
  vec3 v = to_side(side, normalize(frame.eye.xyz - position));
  System warp = fetch_system(side, 0);
  System weft = fetch_system(side, 1);
  float coverage = warp.color.a + weft.color.a;
  vec3 albedo = (warp.color.rgb + weft.color.rgb) / max(coverage, 1e-3);
  float alpha = min(coverage, 1.0);
  float sun = l.z > 0.0 ? sun_seen(position, side.n) : 0.0;
  vec3 key = frame.light_color.rgb * sun / 3.14159265;
#if defined(METHOD_FLAT)
  vec3 color = albedo * (key * max(l.z, 0.0) + sky_diffuse(side.n) * side.sky);
#else
  vec2 open = thread_light(side, l);
  vec3 n = normalize(warp.n * warp.color.a + weft.n * weft.color.a + vec3(0.0, 0.0, 1e-4));
  float facing = (max(dot(warp.n, l), 0.0) * warp.color.a + max(dot(weft.n, l), 0.0) * weft.color.a) / max(coverage, 1e-3);
  vec3 color = albedo * (key * facing * open.x + sky_diffuse(from_side(side, n)) * (side.sky * open.y));
#endif
  out_color = leave(color, alpha);
}
