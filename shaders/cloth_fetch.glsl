// GLSL only: the inputs of a pixel of the cloth: its frame, the lights in it, its footprint, and the two thread
// systems.

#include "filter.glsl"
#include "horizon.glsl"
#include "tables.glsl"
#include "lobes.glsl"
#include "methods.glsl"
#include "engine.glsl"
#include "lattice.glsl"

uniform sampler2DArray color_map;
uniform sampler2DArray relief_map;
uniform sampler2DArray horizon_map;
uniform sampler2DArray response_map;
uniform sampler2D slopes_map;
uniform sampler2D view_map;

in vec3 position;
in vec3 normal;
centroid in vec3 normal_inside;  // where the triangle covers the pixel
centroid in vec3 tangent;
in vec2 tile;
in vec2 sky_visibility;

// The cloth's frame on the visible side: t along the weft, b along the warp, n to the eye. On the back of the mesh it
// is left-handed: both faces are mapped in the same (u, v).
struct Side {
  vec3 t;
  vec3 b;
  vec3 n;
  int face;   // 0: the cloth's front
  float sky;  // sky visibility among the folds
};

Side viewed_side() {
  Side s;
  float turn = gl_FrontFacing ? 1.0 : -1.0;
  vec3 n = normalize(normal);
  // At the centre of a pixel that a narrow triangle covers aside, interpolation leads anywhere: to specks of light.
  vec3 inside = normalize(normal_inside);
  if (dot(n, inside) < 0.9) n = inside;
  s.t = normalize(tangent - n * dot(n, tangent));
  s.b = cross(n, s.t);
  s.n = n * turn;
  s.face = turn * frame.eye.w > 0.0 ? 0 : 1;
  // A pixel's centre may lie outside the triangle, where interpolated values extrapolate.
  s.sky = clamp(gl_FrontFacing ? sky_visibility.x : sky_visibility.y, 0.0, 1.0);
  return s;
}

vec3 to_side(Side s, vec3 w) { return vec3(dot(s.t, w), dot(s.b, w), dot(s.n, w)); }
vec3 from_side(Side s, vec3 w) { return s.t * w.x + s.b * w.y + s.n * w.z; }

// In the side's frame.
struct Lights {
  vec3 l;    // to the key light
  vec3 v;    // to the eye
  vec3 key;  // irradiance of the key light at normal incidence, after the shadows of folds
};

// The view direction in the side's frame. A pixel at the silhouette of a fold covers all slants up to edge-on, and
// only a thin strip of it shines as edge-on cloth does, so it takes the mean slant, where the cosine is linear over
// the pixel. Interpolated normals lean behind the silhouette, by as much as pixels before it would lean.
vec3 view_direction(Side side) {
  vec3 v = to_side(side, normalize(frame.eye.xyz - position));
  float cosine = abs(v.z);
  float most = 0.5 * fwidth(v.z);
  if (cosine < most) cosine = 0.5 * (cosine * cosine / most + most);
  if (cosine > v.z) v.xy *= sqrt((1.0 - cosine * cosine) / max(dot(v.xy, v.xy), 1e-6));
  v.z = max(cosine, 0.02);
  return v;
}

Lights side_lights(Side side) {
  Lights x;
  x.l = to_side(side, current_light().xyz);
  x.v = view_direction(side);
  x.key = current_light_color() * key_visibility(position, x.l.z > 0.0 ? side.n : -side.n);
  return x;
}

// Position of a pixel on the tile, mip levels of the maps, and its size in yarns.
struct Footprint {
  vec2 at;
  vec2 dx;            // one pixel across and down, in tiles
  vec2 dy;
  vec2 axis;         // its longer axis, in tiles
  float ratio;       // longer over shorter axis
  float level;       // mip level for its longer axis
  float level_near;  // mip level for its shorter axis, for facets that face the eye
  float yarns;
};

Footprint footprint_here() {
  Footprint f;
  f.at = tile;
  vec2 texels = vec2(textureSize(color_map, 0).xy);
  f.dx = dFdx(tile);
  f.dy = dFdy(tile);
  vec2 dx = f.dx * texels;
  vec2 dy = f.dy * texels;
  float sum = dot(dx, dx) + dot(dy, dy);
  float area = abs(dx.x * dy.y - dx.y * dy.x);
  float major2 = max(0.5 * (sum + sqrt(max(sum * sum - 4.0 * area * area, 0.0))), 1e-12);
  f.level = 0.5 * log2(major2);
  f.level_near = min(f.level, log2(max(2.0 * area * inversesqrt(major2), 1e-6)));
  f.ratio = clamp(major2 / max(area, 1e-12), 1.0, 16.0);
  // Of the two eigenvectors of the footprint the longer; the sum of both columns if they are equal.
  float xx = dx.x * dx.x + dy.x * dy.x;
  float xy = dx.x * dx.y + dy.x * dy.y;
  float yy = dx.y * dx.y + dy.y * dy.y;
  vec2 along = abs(major2 - xx) > abs(major2 - yy) ? vec2(xy, major2 - xx) : vec2(major2 - yy, xy);
  f.axis = along * inversesqrt(max(dot(along, along), 1e-20)) * sqrt(major2) / texels;
  // By area: at grazing views a pixel is long, but still fine across. It is bounded by its length, since derivatives
  // are noisy where the cloth is seen edge-on.
  f.yarns = sqrt(max(area, major2 / 256.0) / max(texels.x * texels.y, 1.0) * cloth.width_mm * cloth.depth_mm) / cloth.spacing_mm;
  return f;
}

// 0 to 1, different in each pixel and very different from its neighbours (Jimenez 2014, interleaved gradient noise).
float pixel_noise() { return fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715)))); }

// The same, different in each pass.
float pass_noise() { return fract(pixel_noise() + 0.61803399 * frame.samples.x); }

// One thread system of the footprint.
struct System {
  vec4 color;         // premultiplied by coverage
  vec3 n;             // mean normal
  float mean_length;  // length of the mean normal
  vec2 variance;      // of the slopes
};

vec4 fetch_color(Side s, Footprint f, int which) {
  return textureLod(color_map, vec3(f.at, float(s.face * 2 + which)), f.level);
}

void fetch_relief(Side s, Footprint f, int which, inout System y) {
  vec4 r = textureLod(relief_map, vec3(f.at, float(s.face * 2 + which)), f.level) / max(y.color.a, 0.02);
  // E[nx^2] + E[ny^2] + E[nz^2] = 1: the mean of z follows from the moments of x and y.
  float across = max(r.z + r.w, dot(r.xy, r.xy));
  float held = min(1.0, 0.97 / max(across, 1e-4));
  r *= vec4(vec2(sqrt(held)), vec2(held));
  float square = 1.0 - min(across, 0.97);
  y.n = normalize(vec3(r.xy, sqrt(square)));
  float z = 0.25 * square + 0.75 * sqrt(square);   // of a round thread
  y.mean_length = sqrt(dot(r.xy, r.xy) + z * z);
  y.variance = max(r.zw - r.xy * r.xy, vec2(0.0)) / max(y.n.z * y.n.z, 0.05);
}

System fetch_system(Side s, Footprint f, int which) {
  System y;
  y.color = fetch_color(s, f, which);
  fetch_relief(s, f, which, y);
  return y;
}

// Colour of the threads, without the gaps.
vec3 thread_color(Side s, vec4 warp, vec4 weft) {
  vec3 mean = cloth.systems[s.face * 2].color.rgb * cloth.systems[s.face * 2].coverage
            + cloth.systems[s.face * 2 + 1].color.rgb * cloth.systems[s.face * 2 + 1].coverage;
  return (warp.rgb + weft.rgb + mean * 0.004) / (warp.a + weft.a + 0.004);
}

vec3 system_color(vec4 color, SystemData data) {
  return min((color.rgb + data.color.rgb * 0.004) / (color.a + 0.004), vec3(1.0));
}

// Mip level of the horizons: one level, dithered between two; lighting changes little between levels.
float sky_level(Footprint f) { return floor(f.level - 1.0 + pass_noise()); }

// Sky visibility among the threads around.
float thread_sky_visibility(Side s, Footprint f) {
  float layer = cloth.azimuths + float(s.face) * (cloth.azimuths + 1.0);
  return textureLod(horizon_map, vec3(f.at, layer), sky_level(f)).r;
}

// Visibility of the key light (x) and of the sky (y) among the threads around.
vec2 thread_visibility(Side s, Footprint f, vec3 l) {
  int count = int(cloth.azimuths);
  float base = float(s.face * (count + 1));
  HorizonTaps taps = horizon_taps(atan(l.y, l.x), count);
  vec2 a = textureLod(horizon_map, vec3(f.at, base + float(taps.at.y)), sky_level(f)).rg;
  vec2 b = textureLod(horizon_map, vec3(f.at, base + float(taps.at.z)), sky_level(f)).rg;
#if defined(QUICK)
  vec2 h = mix(a, b, taps.weight.z / max(taps.weight.y + taps.weight.z, 1e-4));
#else
  vec2 before = textureLod(horizon_map, vec3(f.at, base + float(taps.at.x)), sky_level(f)).rg;
  vec2 after = textureLod(horizon_map, vec3(f.at, base + float(taps.at.w)), sky_level(f)).rg;
  vec2 h = vec2(horizon_mix(taps, vec4(before.x, a.x, b.x, after.x)), horizon_mix(taps, vec4(before.y, a.y, b.y, after.y)));
#endif
  return vec2(horizon_visibility(abs(l.z), h.x, 0.5 * h.y, current_light().w), thread_sky_visibility(s, f));
}

// Visible fractions and heights of warp and weft along v, over the whole cloth.
struct VisibleSystems {
  vec2 fraction;
  vec2 height;  // mean, mm
  float rise;   // of the warp's visible fraction, with its fraction of the coverage around
};

// View tables of a face along v: 0 visible fractions, 1 and 2 reflected light of a uniform sky by warp and weft, 3 its
// mean directions, 4 correction of method `yarn`: factors by system, and shift of the direction, 5 reflected
// light of hidden directions by warp and weft, and weighted by the visible sky.
vec4 view_table(int face, int table, vec3 v) {
  vec2 c = response_coord(v);
  const float around = float(RESPONSE_VIEWS_AROUND);
  const float up = float(RESPONSE_ELEVATIONS);
  float row = float(face * VIEW_TABLES / 2 + table) * up + c.y;
  return textureLod(view_map, vec2((c.x * around + 0.5) / (around + 1.0), (row + 0.5) / (float(VIEW_TABLES) * up)), 0.0);
}

VisibleSystems visible_systems(int face, vec3 v) {
  vec4 s = view_table(face, 0, v);
  return VisibleSystems(vec2(s.x, 1.0 - s.x), s.zw, s.y);
}

// Coverage along w of cloth with `coverage` at normal view.
float cover_along(float coverage, vec3 w) {
  if (cloth.open < 0.5) return 1.0;
  return coverage_by_view(min(coverage, 1.0), vec2(cloth.gap_u_mm, cloth.gap_v_mm), cloth.rim_mm, w);
}

// Coverage of the pixel by threads, for the prefiltered methods.
float cover_of(Side side, Lights x, Footprint f) {
  return cover_along(fetch_color(side, f, 0).a + fetch_color(side, f, 1).a, x.v);
}
