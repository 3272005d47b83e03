// GLSL only: fetches the threads from their map (thread_records.glsl) for threads.glsl.

uniform usampler2D thread_map;
#if defined(COMPUTED_CROSSINGS)
uniform usampler2DArray crossing_map;   // strips of cells (core/render_data/thread_block.h)
#else
uniform sampler2DArray crossing_map;
#endif

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

#if defined(COMPUTED_CROSSINGS)
vec4 crossing_at(int end, int pick);

uint thread_cells(int system, int thread, int crossing) {
  ivec2 strips = (threads_head.count + STRIP_CELLS - 1) / STRIP_CELLS;   // along a pick, along an end
  int strip = crossing / STRIP_CELLS;
  int i = system == 1 ? thread * strips.x + strip : threads_head.count.y * strips.x + thread * strips.y + strip;
  int row = i / STRIP_MAP_WIDTH;
  ivec3 at = ivec3(i & (STRIP_MAP_WIDTH - 1), row & (STRIP_MAP_HEIGHT - 1), row / STRIP_MAP_HEIGHT);
  return texelFetch(crossing_map, at, 0).x >> uint(crossing - strip * STRIP_CELLS);
}
#else
vec4 crossing_at(int end, int pick) {
  int block = (pick / CROSSING_BLOCK) * threads_head.crossing_blocks + end / CROSSING_BLOCK;
  return texelFetch(crossing_map, ivec3(end & (CROSSING_BLOCK - 1), pick & (CROSSING_BLOCK - 1), block), 0);
}
#endif

#if defined(STRAIGHT_THREADS) || defined(COMPUTED_CROSSINGS)
vec2 aside_at(int end, int pick) { return vec2(0.0); }
#else
// After the blocks of the crossings.
vec2 aside_at(int end, int pick) {
  int rows = (threads_head.count.y + CROSSING_BLOCK - 1) / CROSSING_BLOCK;
  int block = (rows + pick / CROSSING_BLOCK) * threads_head.crossing_blocks + end / CROSSING_BLOCK;
  return texelFetch(crossing_map, ivec3(end & (CROSSING_BLOCK - 1), pick & (CROSSING_BLOCK - 1), block), 0).xy;
}
#endif

ThreadHead head_at(int i) {
  return thread_head(thread_texel(i), thread_texel(i + 1), thread_texel(i + 2), thread_texel(i + 3), thread_texel(i + 4));
}

ThreadGrid thread_layer(int layer, float side) { return grid_of(head_at(layer * THREAD_HEAD_TEXELS), side); }

#include "threads.glsl"

#if defined(COMPUTED_CROSSINGS)
#include "crossings.glsl"

vec4 crossing_at(int end, int pick) { return computed_crossing(grid_of(threads_head, 1.0), end, pick); }
#endif

// Call once a pixel, before everything else here.
ThreadGrid thread_grid(int face) {
  threads_head = head_at(0);
  return grid_of(threads_head, face == 0 ? 1.0 : -1.0);
}

// The grid of the layer that was hit.
ThreadGrid hit_layer(ThreadGrid g, ThreadHit hit) {
#if defined(ONE_LAYER)
  return g;
#else
  return thread_layer(hit.layer, g.side);
#endif
}

// A thread's linear colour at a position along it in mm, and its yarn in w. DYED_ALONG is defined where the colour of some
// thread changes along it. g: of the thread's layer.
vec4 thread_dye(ThreadGrid g, int system, int thread, float along) {
  vec4 dye = record_color(thread_texel(record_at(system, thread) + THREAD_COLOR));
#if defined(DYED_ALONG)
  ivec4 own = ivec4(thread_texel(record_at(system, thread) + THREAD_DYE));
  if (own.y > 0) {
    float period = system == 0 ? g.period.y : g.period.x;
    int crossed = thread_at(g, 1 - system, along - floor(along / period) * period);
    int place = int(thread_texel(record_at(1 - system, crossed) + THREAD_DYE).w);
    dye.rgb = uintBitsToFloat(thread_texel(own.x + (place + own.z) % own.y).rgb);
  }
#endif
  return dye;
}

ThreadTexture thread_pattern(int system, int thread, float side) {
  int i = record_at(system, thread) + THREAD_PATTERN;
  return pattern_on(record_pattern(thread_texel(i), thread_texel(i + 1), thread_texel(i + 2), thread_texel(i + 3), thread_texel(i + 4)), side);
}

// Lobes of a yarn on a thread of this colour.
YarnLobes thread_lobes(int yarn, vec3 color) {
  int i = threads_head.yarns + yarn * YARN_TEXELS;
  return yarn_of(record_yarn(thread_texel(i), thread_texel(i + 1), thread_texel(i + 2), thread_texel(i + 3)), color);
}
