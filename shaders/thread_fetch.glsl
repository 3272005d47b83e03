// GLSL only: the threads as the tables hold them (editor/preview/thread_block.h), for threads.glsl.

uniform usampler2D thread_map;
uniform sampler2DArray crossing_map;

#include "thread_texture.glsl"

// First texels of the ends, of the picks, of both tables of bins.
ivec4 thread_tables = ivec4(0);
int crossing_blocks = 1;
int yarn_table = 0;

uvec4 thread_texel(int i) { return texelFetch(thread_map, ivec2(i & (THREAD_MAP_WIDTH - 1), i / THREAD_MAP_WIDTH), 0); }

vec4 thread_body(int system, int thread) {
  return uintBitsToFloat(thread_texel((system == 0 ? thread_tables.x : thread_tables.y) + thread * THREAD_TEXELS));
}

int thread_bin(int system, int bin) {
  uvec4 four = thread_texel((system == 0 ? thread_tables.z : thread_tables.w) + bin / 4);
  return int(four[bin & 3]);
}

vec4 crossing_at(int end, int pick) {
  int block = (pick / CROSSING_BLOCK) * crossing_blocks + end / CROSSING_BLOCK;
  return texelFetch(crossing_map, ivec3(end & (CROSSING_BLOCK - 1), pick & (CROSSING_BLOCK - 1), block), 0);
}

#include "threads.glsl"

// Once a pixel, before all else here.
ThreadGrid thread_grid(int face) {
  uvec4 counts = thread_texel(0);
  vec4 sizes = uintBitsToFloat(thread_texel(1));
  uvec4 rest = thread_texel(3);
  thread_tables = ivec4(thread_texel(2));
  yarn_table = int(rest.x);
  crossing_blocks = int(rest.y);
  ThreadGrid g;
  g.count = ivec2(counts.xy);
  g.bins = ivec2(counts.zw);
  g.period = sizes.xy;
  g.spacing = sizes.z;
  g.top = sizes.w;
  g.side = face == 0 ? 1.0 : -1.0;
  g.even = uintBitsToFloat(rest.zw);
  return g;
}

// A thread's linear colour, and its yarn in w.
vec4 thread_look(int system, int thread) {
  uvec4 t = thread_texel((system == 0 ? thread_tables.x : thread_tables.y) + thread * THREAD_TEXELS + 1);
  return vec4(uintBitsToFloat(t.xyz), float(t.w));
}

// The back is mapped as the front and seen mirrored: its twist runs the other way there to be the same in space.
ThreadTexture thread_pattern(int system, int thread, float side) {
  int i = (system == 0 ? thread_tables.x : thread_tables.y) + thread * THREAD_TEXELS + 2;
  uvec4 a = thread_texel(i);
  uvec4 b = thread_texel(i + 1);
  uvec4 c = thread_texel(i + 2);
  uvec4 d = thread_texel(i + 3);
  int hand = side < 0.0 ? -1 : 1;
  ThreadTexture x;
  x.fibres = uintBitsToFloat(a.x);
  x.advance = int(a.y) * hand;
  x.fibre_tan = uintBitsToFloat(a.z) * side;
  x.plies = int(a.w);
  x.ply_advance = int(b.x) * hand;
  x.ply_relief_mm = uintBitsToFloat(b.y);
  x.phase = uintBitsToFloat(b.z);
  x.ply_phase = uintBitsToFloat(b.w);
  x.singles = int(c.x);
  x.stray_advance = int(c.y) * hand;
  x.nodes = int(c.z);
  x.depth = uintBitsToFloat(c.w);
  x.hair = uintBitsToFloat(d.x);
  x.radius_mm = uintBitsToFloat(d.y);
  x.seed = d.z;
  return x;
}

// Lobes of a yarn on a thread of that colour.
YarnLobes thread_lobes(int yarn, vec3 color) {
  int i = yarn_table + yarn * YARN_TEXELS;
  return yarn_of(uintBitsToFloat(thread_texel(i)), uintBitsToFloat(thread_texel(i + 1)), uintBitsToFloat(thread_texel(i + 2)),
                 uintBitsToFloat(thread_texel(i + 3)), color);
}
