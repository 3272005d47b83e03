// GLSL only: what a pixel of the cloth knows: its frame, the lights in it, and the two thread systems.

#include "filter.glsl"
#include "horizon.glsl"

uniform sampler2DArray color_map;
uniform sampler2DArray relief_map;
uniform sampler2DArray horizon_map;

in vec3 position;
in vec3 normal;
in vec3 tangent;
in vec2 tile;
in vec2 sky_seen;

// The cloth's frame, on the side that is seen: t along the weft, b along the warp, n to the eye. On the back
// of the mesh it is left-handed: both faces are mapped in the same (u, v).
struct Side {
  vec3 t;
  vec3 b;
  vec3 n;
  int face;          // 0: the cloth's front
  float sky;         // share of the sky that the folds leave
  float sky_behind;
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
  s.sky_behind = gl_FrontFacing ? sky_seen.y : sky_seen.x;
  return s;
}

vec3 to_side(Side s, vec3 w) { return vec3(dot(s.t, w), dot(s.b, w), dot(s.n, w)); }
vec3 from_side(Side s, vec3 w) { return s.t * w.x + s.b * w.y + s.n * w.z; }

// In the side's frame.
struct Lights {
  vec3 l;       // to the key light
  vec3 v;       // to the eye
  vec3 key;     // irradiance of the key light at right angles, after the shadows of the folds
};

Lights seen_lights(Side side) {
  Lights x;
  x.l = to_side(side, frame.light.xyz);
  x.v = to_side(side, normalize(frame.eye.xyz - position));
  // Interpolated normals lean behind the silhouette: held to the side that is seen.
  x.v.z = max(x.v.z, 0.02);
  x.key = frame.light_color.rgb * sun_seen(position, x.l.z > 0.0 ? side.n : -side.n);
  return x;
}

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
#if defined(METHOD_YARN)
  vec4 r = texture(relief_map, vec3(tile, layer)) / max(y.color.a, 0.02);
  // E[nx^2] + E[ny^2] + E[nz^2] = 1: the mean of z follows from the moments of x and y.
  float across = dot(r, r);
  r *= min(1.0, sqrt(0.97 / max(across, 1e-4)));
  y.n = vec3(r.xy, sqrt(1.0 - min(across, 0.97)));
  y.variance = r.zw * r.zw;
#endif
  return y;
}

// Colour of the threads, without the gaps.
vec3 thread_color(Side s, System warp, System weft) {
  vec3 mean = cloth.systems[s.face * 2].mean.rgb * cloth.systems[s.face * 2].extra.y
            + cloth.systems[s.face * 2 + 1].mean.rgb * cloth.systems[s.face * 2 + 1].extra.y;
  return (warp.color.rgb + weft.color.rgb + mean * 0.004) / (warp.color.a + weft.color.a + 0.004);
}

// Share of the key light (x) and of the sky (y) that the threads around leave.
vec2 thread_light(Side s, vec3 l) {
  int count = int(cloth.size.w);
  float base = float(s.face * (count + 1));
  HorizonTaps taps = horizon_taps(atan(l.y, l.x), count);
  vec2 a = texture(horizon_map, vec3(tile, base + float(taps.at.y))).rg;
  vec2 b = texture(horizon_map, vec3(tile, base + float(taps.at.z))).rg;
#if defined(QUICK)
  vec2 h = mix(a, b, taps.weight.z / max(taps.weight.y + taps.weight.z, 1e-4));
#else
  vec2 before = texture(horizon_map, vec3(tile, base + float(taps.at.x))).rg;
  vec2 after = texture(horizon_map, vec3(tile, base + float(taps.at.w))).rg;
  vec2 h = vec2(horizon_mix(taps, vec4(before.x, a.x, b.x, after.x)), horizon_mix(taps, vec4(before.y, a.y, b.y, after.y)));
#endif
  float occlusion = texture(horizon_map, vec3(tile, base + float(count))).r;
  return vec2(horizon_visibility(l.z, h.x, 0.5 * h.y, frame.light.w), occlusion);
}
