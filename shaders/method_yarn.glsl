// SampledMethod `yarn`: the threads themselves. Samples spread over the pixel follow the eye's ray to the thread that it
// meets, take that thread's own frame, pattern and lobes, and follow a ray to the light; so threads hide and shade
// each other as bodies do, light from behind comes through the thread alone, and gaps are where no thread is.
//
// Based on: Vogel 1979 (places on the light's disc); those in the pixel: lattice.glsl.

#include "thread_fetch.glsl"

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
  vec3 soft;
  vec3 glossy;
  vec3 soft_from;     // mean direction of the sky's light that each sends, times how much it sends
  vec3 glossy_from;
  float cover;
};

// Towards a point of the light's disc. own: 0 to 1, of the pixel, so that few samples leave grain and no false edge.
vec3 light_sample(vec3 l, int i, float own) {
  // Steps that agree with none of the lattices', or each side of the pixel would see one side of the light.
  float r = sqrt(fract(0.56984029 * float(i) + 5.0 * own)) * light_here().w;
  float turn = 6.2831853 * (0.41421356 * float(i) + own);
  vec3 a = normalize(abs(l.z) < 0.9 ? cross(l, vec3(0.0, 0.0, 1.0)) : cross(l, vec3(1.0, 0.0, 0.0)));
  return normalize(l + (a * cos(turn) + cross(l, a) * sin(turn)) * r);
}

// One sample at `at`, dx by dy large, all on the middle plane in mm; l: to a point of the light. It hides and shades by
// that point alone; what the thread answers is of all the light's disc and of all the surface that the sample covers.
void add_sample(inout YarnSums sums, ThreadGrid g, Lights x, vec2 measured, vec2 at, vec2 dx, vec2 dy, vec3 l) {
  ThreadHit hit = first_thread(g, at, x.v, kViewCells);
  if (hit.system < 0) return;
  sums.cover += 1.0;
  int thread = hit.strand.thread;
  float length_mm = hit.system == 0 ? g.period.y : g.period.x;
  ThreadPoint p = thread_point(hit.system, hit.strand, hit.at);
  ThreadTexture pattern = thread_pattern(hit.system, thread, g.side);
  float sample_mm = sqrt(abs(dx.x * dy.y - dx.y * dy.x));
  float across = sample_mm / (6.2831853 * pattern.radius_mm * max(abs(p.normal.z), 0.1));
  float along = sample_mm / length_mm;
  float cycles = max(pattern.fibres * across, abs(float(pattern.advance)) * along);
  float ply_cycles = max(float(pattern.plies) * across, abs(float(pattern.ply_advance)) * along);
  Texel texel = texture_at(pattern, texture_point(pattern, fract(p.along / length_mm), p.turn, cycles, contrast_left(ply_cycles)));
  vec3 n = p.normal;
  if (pattern.plies > 1) n = ply_normal(p, pattern, texel.ply, length_mm);
  if (dot(n, x.v) <= 0.0) n = p.normal;
  vec4 look = thread_look(hit.system, thread);
  YarnLobes lobes = thread_lobes(int(look.w), fibre_colour(texel, look.rgb));
  float disc = light_here().w * light_here().w / 16.0;   // of the half vector's slopes
  float covered = x.l.z > 0.0 ? 1.0 : 0.0;
  lobes = yarn_widen(lobes, slope_spread(p, pattern.fibre_tan, x.v, dx, dy) * covered + vec3(disc, 0.0, disc));
  Answer a = facet_answer(lobes, n, 1.0, p.axis + p.around * pattern.fibre_tan, vec3(0.0), x.l, x.v);
  a.key *= texel.groove;
  // Light from behind crosses this thread itself; every other one stops it. Where it falls on a side that hangs over, the
  // thread may stand before itself, too: from a little above it.
  bool side = l.z < 0.0 && dot(p.normal, l) > 0.0;
  vec3 from = side ? hit.at + p.normal * (0.02 * g.top) : hit.at;
  if (a.key.r + a.key.g + a.key.b > 0.0 && threads_block(g, from, l, kLightCells, side ? -1 : hit.system, thread)) a.key = vec3(0.0);
  sums.key += a.key;
  float sky = texel.groove * (hit.system == 0 ? measured.x : measured.y);
  vec3 mirrored = reflect(-x.v, n);
  a.soft *= sky * facet_seen(n);
  a.glossy *= sky * mirrored_seen(mirrored);
  sums.soft += a.soft;
  sums.glossy += a.glossy;
  sums.soft_from += facet_seen_from(n) * (a.soft.r + a.soft.g + a.soft.b);
  sums.glossy_from += mirrored_seen_from(mirrored) * (a.glossy.r + a.glossy.g + a.glossy.b);
}

// Radiance of what is covered, and cover.
vec4 shade_yarn(Side side, Lights x, Footprint f) {
  ThreadGrid g = thread_grid(side.face);
  int pass = int(frame.samples.x);
  ivec2 lattice = lattice_of(lattice_for(f.yarns, frame.lattices[0], frame.lattices[1], int(frame.samples.y)));
  int count = lattice.x;
  vec2 middle = fract(f.at) * g.period;
  float part = inversesqrt(float(count));
  vec2 dx = f.dx * g.period;
  vec2 dy = f.dy * g.period;
  YarnSums sums = YarnSums(vec3(0.0), vec3(0.0), vec3(0.0), vec3(0.0), vec3(0.0), 0.0);
  vec4 measured = seen_along(side.face, 4, x.v);
  float own = pixel_turn();
  // Where pixels hold a good part of a yarn, equal samples would meet equal places of the weave in many of them. So many
  // steps of R2 as spread them over the whole pixel, not along one line of it.
  float turn = 64.0 * own * clamp(f.yarns * 4.0 - 1.0, 0.0, 1.0);
  int i = 0;
  do {
    vec2 r = lattice_point(lattice, i, pass, turn);
    add_sample(sums, g, x, measured.xy, middle + dx * r.x + dy * r.y, dx * part, dy * part, light_sample(x.l, pass * count + i, own));
    ++i;
  } while (i < count);   // threads.glsl says why
  if (sums.cover < 0.5) return vec4(0.0);
  float scale = 1.0 / sums.cover;
  vec3 soft_from = sums.soft_from / max(sums.soft.r + sums.soft.g + sums.soft.b, 1.0e-6);
  vec3 glossy_from = sums.glossy_from / max(sums.glossy.r + sums.glossy.g + sums.glossy.b, 1.0e-6);
  glossy_from += vec3(x.v.xy * (measured.z * inversesqrt(max(dot(x.v.xy, x.v.xy), 1.0e-8))), measured.w);
  vec3 sky = sums.soft * sky_about(from_side(side, soft_from)) + sums.glossy * sky_about(from_side(side, glossy_from));
  vec3 radiance = (x.key * sums.key + sky * side.sky) * scale;
  return vec4(radiance, sums.cover / float(count));
}
