// Method `yarn`: the threads themselves. Samples over the pixel follow the view ray to a thread, shade with its frame,
// pattern and lobes, and follow a ray to the light; so threads mask and shadow each other, light from behind passes
// through the thread alone, and gaps are where no thread is.
//
// Based on: Vogel 1979 (points on the light's disc); those in the pixel: lattice.glsl.

#include "thread_fetch.glsl"
#include "flyaway.glsl"
#include "interreflection.glsl"

#if defined(QUICK)
const int kViewCells = 8;
const int kLightCells = 4;
#else
const int kViewCells = 48;
const int kLightCells = 24;
#endif

// Means over the samples of a pixel.
struct YarnSums {
  vec3 key;
  vec3 diffuse;
  vec3 glossy;
  vec3 diffuse_from;     // mean direction of the sky light of each, times its amount
  vec3 glossy_from;
  vec3 hidden;           // reflected from directions that other threads hide
  float cover;
};

// Direction to a point of the light's disc. own: 0 to 1, by pixel, so that few samples give noise instead of false
// edges.
vec3 light_sample(vec3 l, int i, float own) {
  // Steps that differ from those of the lattices; otherwise each side of the pixel would see one side of the light.
  float r = sqrt(fract(0.56984029 * float(i) + 5.0 * own)) * current_light().w;
  float turn = 6.2831853 * (0.41421356 * float(i) + own);
  vec3 a = normalize(abs(l.z) < 0.9 ? cross(l, vec3(0.0, 0.0, 1.0)) : cross(l, vec3(1.0, 0.0, 0.0)));
  return normalize(l + (a * cos(turn) + cross(l, a) * sin(turn)) * r);
}

// Colour of the thread that a flyaway fibre at `at` (mm) comes from; w: fuzz of its yarn, over the larger of both
// systems, 0 between the threads.
vec4 flyaway_root(int face, ThreadGrid g, vec2 at) {
  vec2 tile = at / g.period;
  float level = max(log2(float(textureSize(color_map, 0).x) * g.spacing / g.period.x) - 2.0, 0.0);
  vec4 warp = textureLod(color_map, vec3(tile, float(face * 2)), level);
  vec4 weft = textureLod(color_map, vec3(tile, float(face * 2 + 1)), level);
  vec2 fraction = vec2(flyaway_fraction(cloth.systems[face * 2].yarn.fuzz), flyaway_fraction(cloth.systems[face * 2 + 1].yarn.fuzz));
  vec4 top = warp.a > weft.a ? warp : weft;
  float own = top.a < 0.02 ? 0.0 : warp.a > weft.a ? fraction.x : fraction.y;
  return vec4(clamp(top.rgb / max(top.a, 0.02), 0.0, 1.0), own / max(max(fraction.x, fraction.y), 1.0e-6));
}

// How fibres over the face are laid out.
struct FaceLayout {
  float fuzz;    // larger fraction of both systems
  float depth;
  vec2 cells;    // in the period
  vec2 size;     // of a cell, mm
  float drawn;   // 0: none
  float nap;     // 0 to 1: fibres that lie over the threads in all directions
  float under;   // fraction of the light that reaches the threads under those drawn one by one
  float lit;     // fraction of the key light that reaches threads under a nap; 0 without one
  float open;    // fraction of the key light that reaches the fibres: from behind, what the gaps let through
};

FaceLayout face_layout(Side side, ThreadGrid g, Footprint f, vec3 l) {
  YarnData warp = cloth.systems[side.face * 2].yarn;
  YarnData weft = cloth.systems[side.face * 2 + 1].yarn;
  FaceLayout a;
  a.fuzz = max(warp.fuzz, weft.fuzz);
  a.depth = max(warp.fuzz_depth, weft.fuzz_depth);
  a.drawn = flyaway_fraction(a.fuzz) > 0.0 ? face_flyaways_drawn(f.yarns) : 0.0;
  a.nap = nap_of(a.fuzz);
  a.lit = a.nap > 0.0 ? thread_visibility(side, f, l).x : 0.0;
  float cover = cloth.systems[side.face * 2].coverage + cloth.systems[side.face * 2 + 1].coverage;
  a.open = mix(1.0 - cover_along(cover, l), 1.0, clamp(1.0 + 10.0 * l.z, 0.0, 1.0));   // without a seam where l is level
  a.cells = max(floor(g.period / face_cell(a.fuzz, a.depth, g.spacing)), vec2(1.0));
  a.size = g.period / a.cells;
  a.under = face_flyaways_pass(a.fuzz, kFlyawayLength * a.depth, a.size, a.drawn);
  return a;
}

// Flyaway fibres over the face of the cloth: radiance times cover, and cover.
vec4 face_flyaways(Side side, Lights x, ThreadGrid g, FaceLayout a, vec2 middle, vec2 dx, vec2 dy) {
  vec4 sum = vec4(0.0);
  int count = int(ceil(min(face_flyaways_in(a.fuzz, a.size.x * a.size.y), max_face_flyaways(a.fuzz))));
  vec2 lean = x.v.xy / max(x.v.z, 0.2);
  vec2 at = middle + lean * g.top;
  vec2 corner = floor(at / a.size - 0.5);
  vec2 rise = lean * (0.6 * g.top);   // of the highest
  // The higher the brighter, above all in a nap.
  vec2 brightness = mix(vec2(0.65, 0.65), vec2(0.3, 1.35), nap_of(a.fuzz));
  float reach = 1.2 * flyaway_reach(a.size) + 0.5 * length(rise) + length(dx) + length(dy);   // with its bend
  int k = 0;
  do {
    vec2 own = corner + vec2(float(k & 1), float(k >> 1));
    vec2 cell = own - a.cells * floor(own / a.cells);
    uint seed = uint(cell.x) * 4099u + uint(cell.y);   // the same on both faces
    int i = 0;
    do {
      uint bits = flyaway_bits(seed, uint(i));
      ++i;
      vec2 off = at - own * a.size + 0.5 * rise - flyaway_middle(bits, a.size);
      if (dot(off, off) > reach * reach) continue;
      FaceFlyaway f = face_flyaway(bits, a.size, kFlyawayLength * a.depth);
      vec2 found = flyaway_at(f, at - own * a.size + rise * f.height, dx, dy);
      if (found.x > 0.0) {
        vec4 root = flyaway_root(side.face, g, own * a.size + f.middle);
        if (f.present < root.w) {
          vec3 body = root.rgb * (brightness.x + brightness.y * f.height);
          vec3 clear = sqrt(body * sqrt(body));   // between that of a fibre and of the yarn, which surrounds it
          vec3 along = normalize(vec3(f.way + vec2(-f.way.y, f.way.x) * found.y, 0.3 * f.bend));
          vec3 lit = x.key * a.open * flyaway_key(clear, body, along, vec3(0.0, 0.0, 1.0), x.l, x.v)
                   + flyaway_sky(clear, body) * sky_diffuse(side.n) * side.sky;
          float cover = found.x * a.drawn * (1.0 - sum.a);
          sum += vec4(lit * (kFaceLight * cover), cover);
        }
      }
    } while (i < count);
    ++k;
  } while (k < 4);
  return sum;
}

// Where threads of one system touch, a slanted ray that slips between them, since they are round, would meet the fibres
// that fill the room: those of the thread nearest to it at the middle plane. No thread where one sees through from
// straight above, too.
ThreadHit nearest_thread(ThreadGrid g, vec2 at) {
  Crossing c = crossing_near(g, at);
  vec3 p = vec3(at, 0.0);
  ThreadHit hit = hit_of(c, p, near_distances(c, p));
#if !defined(CLOSED_CLOTH)
  if (!lies_under(c.warp, at.x, at.y) && !lies_under(c.weft, at.y, at.x)) hit.system = -1;
#endif
  return hit;
}

// One sample at `at`, of size dx by dy, all on the middle plane in mm; l: to a point of the light. Masking and
// shadowing are by that point alone; shading is over the whole disc of the light and the whole area of the sample.
// measured, weight: by system, of the visible sky (view_table()) and of hidden directions (Interreflection). faces: the
// fibres that are drawn over it and not in its lobes.
void add_sample(inout YarnSums sums, ThreadGrid g, Lights x, FaceLayout faces, vec2 measured, vec2 weight, vec2 at, vec2 dx, vec2 dy, vec3 l) {
  ThreadHit hit = first_thread(g, at, x.v, kViewCells);
  if (hit.system < 0 && min(cloth.gap_u_mm, cloth.gap_v_mm) < 0.01 * g.spacing) hit = nearest_thread(g, at);
  if (hit.system < 0) return;
  sums.cover += 1.0;
  int thread = hit.strand.thread;
  float length_mm = hit.system == 0 ? g.period.y : g.period.x;
  ThreadPoint p = thread_point(hit.system, hit.strand, hit.at);
  ThreadTexture pattern = thread_pattern(hit.system, thread, g.side);
  SurfaceFrame frame_at = SurfaceFrame(p.normal, p.axis, p.around);
  vec2 size = sample_size(pattern, sqrt(abs(dx.x * dy.y - dx.y * dy.x)), p.normal.z, length_mm);
  FibreDetail detail = fibre_detail(pattern, fract(p.along / length_mm), p.turn, size, length_mm);
  Texel texel = detail.texel;
  vec4 dye = thread_dye(hit_layer(g, hit), hit.system, thread, p.along);
  YarnLobes lobes = thread_lobes(int(dye.w), fibre_colour(texel, dye.rgb));
  float relief = fibre_relief(lobes.slope_cov.z, nap_of(lobes.fuzz));
  vec3 n = detail_normal(frame_at, pattern, detail, relief, length_mm, x.v);
  lobes = detail_lobes(lobes, detail.resolved, relief);
  lobes.fuzz = fuzz_left(lobes.fuzz, faces.size.x * faces.size.y, faces.drawn);
  float disc = current_light().w * current_light().w / 16.0;   // of the half vector's slopes
  float covered = x.l.z > 0.0 ? 1.0 : 0.0;
  lobes = yarn_widen(lobes, slope_spread(p, detail.fibre_tan, x.v, dx, dy) * covered + vec3(disc, 0.0, disc));
  Reflected a = facet_radiance(lobes, n, 1.0, p.axis + p.around * detail.fibre_tan, vec3(0.0), x.l, x.v);
  float light = texel.groove * detail_gain(pattern, detail, relief);
  a.key *= light * ply_light(frame_at, pattern, detail, length_mm, l);
  // Light from behind first passes through this thread, or falls on its overhanging side; every other one occludes it.
  // The ray starts on the surface: where threads touch, a point above it lies in the neighbour. In the shade of folds
  // no ray is needed: there x.key is 0.
  vec3 unhidden = x.key * a.key;
  bool blocked = unhidden.r + unhidden.g + unhidden.b > 0.0 && (faces.nap < 1.0 || l.z <= 0.0)
              && threads_block(g, hit.at, l, kLightCells, hit.system, thread);
  // A nap scatters the light into the shadows between the threads: all have the mean.
  a.key *= mix(blocked ? 0.0 : 1.0, faces.lit, l.z > 0.0 ? faces.nap : 0.0);
  sums.key += a.key;
  float seen_sky = hit.system == 0 ? measured.x : measured.y;
  vec3 mirrored = reflect(-x.v, n);
  vec2 open = vec2(facet_sky_visibility(n), mirrored_sky_visibility(mirrored)) * seen_sky;
  // Threads that hide much of the sky stand in shadow as this one does.
  vec2 hidden = max(open * (1.0 - open), vec2(0.0)) * (hit.system == 0 ? weight.x : weight.y);
  sums.hidden += (a.diffuse * hidden.x + a.glossy * hidden.y) * light;
  a.diffuse *= light * open.x;
  a.glossy *= light * open.y;
  sums.diffuse += a.diffuse;
  sums.glossy += a.glossy;
  sums.diffuse_from += facet_sky_direction(n) * (a.diffuse.r + a.diffuse.g + a.diffuse.b);
  sums.glossy_from += mirrored_sky_direction(mirrored) * (a.glossy.r + a.glossy.g + a.glossy.b);
}

// Radiance of the covered part, and coverage.
vec4 shade_yarn(Side side, Lights x, Footprint f) {
  ThreadGrid g = thread_grid(side.face);
  int pass = int(frame.samples.x);
  ivec2 lattice = lattice_of(lattice_for(f.yarns, frame.lattices[0], frame.lattices[1], int(frame.samples.y)));
  int count = lattice.x;
  vec2 middle = fract(f.at) * g.period;
  float part = inversesqrt(float(count));
  vec2 dx = f.dx * g.period;
  vec2 dy = f.dy * g.period;
  YarnSums sums = YarnSums(vec3(0.0), vec3(0.0), vec3(0.0), vec3(0.0), vec3(0.0), vec3(0.0), 0.0);
  vec4 measured = view_table(side.face, 4, x.v);
  Interreflection around = interreflection(side, x, f);
  float own = pixel_noise();
  FaceLayout faces = face_layout(side, g, f, x.l);
  faces.drawn *= clamp(3.0 * x.v.z - 0.5, 0.0, 1.0);   // seen along the face they overlap, as the lobe's do
  // Where a pixel covers much of a yarn, equal samples would hit equal points of the weave in many pixels. So many
  // steps of R2 spread them over the whole pixel instead of along a line.
  float turn = 64.0 * own * clamp(f.yarns * 4.0 - 1.0, 0.0, 1.0);
  int i = 0;
  do {
    vec2 r = lattice_point(lattice, i, pass, turn);
    add_sample(sums, g, x, faces, measured.xy, around.weight, middle + dx * r.x + dy * r.y, dx * part, dy * part, light_sample(x.l, pass * count + i, own));
    ++i;
  } while (i < count);   // threads.glsl says why
  vec4 flyaways = vec4(0.0);
  if (faces.drawn > 0.0) flyaways = face_flyaways(side, x, g, faces, middle, dx, dy);
  if (sums.cover < 0.5) return vec4(flyaways.rgb / max(flyaways.a, 1.0e-4), flyaways.a);
  float scale = 1.0 / sums.cover;
  vec3 diffuse_from = sums.diffuse_from / max(sums.diffuse.r + sums.diffuse.g + sums.diffuse.b, 1.0e-6);
  vec3 glossy_from = sums.glossy_from / max(sums.glossy.r + sums.glossy.g + sums.glossy.b, 1.0e-6);
  glossy_from += vec3(x.v.xy * (measured.z * inversesqrt(max(dot(x.v.xy, x.v.xy), 1.0e-8))), measured.w);
  vec3 sky = sums.diffuse * sky_about(from_side(side, diffuse_from)) + sums.glossy * sky_about(from_side(side, glossy_from));
  vec3 radiance = (around.alone * faces.under) * (x.key * sums.key + sky * side.sky + sums.hidden * around.radiance) * scale;
  float cover = sums.cover / float(count) * (1.0 - flyaways.a);
  return vec4((radiance * cover + flyaways.rgb) / (cover + flyaways.a), cover + flyaways.a);
}
