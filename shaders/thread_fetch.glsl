// GLSL only: fetches the threads from their map (thread_records.glsl) for threads.glsl.

uniform usampler2D thread_map;
uniform sampler2DArray crossing_map;

#include "thread_records.glsl"

ThreadHead threads_head;

uvec4 thread_texel(int i) { return texelFetch(thread_map, ivec2(i & (THREAD_MAP_WIDTH - 1), i / THREAD_MAP_WIDTH), 0); }

int record_at(int system, int thread) { return threads_head.threads[system] + thread * THREAD_TEXELS; }

ThreadSection thread_body(int system, int thread) {
  return record_body(thread_texel(record_at(system, thread) + THREAD_BODY));
}

int thread_bin(int system, int bin) {
  uvec4 four = thread_texel(threads_head.bins[system] + bin / 4);
  return int(four[bin & 3]);
}

vec4 crossing_at(int end, int pick) {
  int block = (pick / CROSSING_BLOCK) * threads_head.crossing_blocks + end / CROSSING_BLOCK;
  return texelFetch(crossing_map, ivec3(end & (CROSSING_BLOCK - 1), pick & (CROSSING_BLOCK - 1), block), 0);
}

ThreadHead head_at(int i) {
  return thread_head(thread_texel(i), thread_texel(i + 1), thread_texel(i + 2), thread_texel(i + 3), thread_texel(i + 4));
}

ThreadGrid thread_layer(int layer, float side) { return grid_of(head_at(layer * THREAD_HEAD_TEXELS), side); }

#include "threads.glsl"

// Call once a pixel, before everything else here.
ThreadGrid thread_grid(int face) {
  threads_head = head_at(0);
  return grid_of(threads_head, face == 0 ? 1.0 : -1.0);
}

// A thread's linear colour, and its yarn in w.
vec4 thread_dye(int system, int thread) { return record_color(thread_texel(record_at(system, thread) + THREAD_COLOR)); }

ThreadTexture thread_pattern(int system, int thread, float side) {
  int i = record_at(system, thread) + THREAD_PATTERN;
  return pattern_on(record_pattern(thread_texel(i), thread_texel(i + 1), thread_texel(i + 2), thread_texel(i + 3)), side);
}

// Lobes of a yarn on a thread of this colour.
YarnLobes thread_lobes(int yarn, vec3 color) {
  int i = threads_head.yarns + yarn * YARN_TEXELS;
  return yarn_of(record_yarn(thread_texel(i), thread_texel(i + 1), thread_texel(i + 2), thread_texel(i + 3)), color);
}
