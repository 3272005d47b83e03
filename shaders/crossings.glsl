// Height and slope of the threads at any crossing, computed from the drawdown: for drafts of more crossings than are
// stored (core/render_data/thread_block.h). One layer. GLSL 3.30 and C++20; after threads.glsl, whose crossing_at() it
// provides:
//
//   vec4 c = computed_crossing(grid, end, pick)    height and slope of the warp, of the weft, on the front
//
// The host declares, besides what threads.glsl asks for:
//   uint thread_cells(int system, int thread, int crossing)   the cells along a thread from STRIP_MARGIN before this
//                                                             crossing on, the first in the lowest bit; 1: warp above

#include "crossing_height.glsl"

// Crossings of the same float beyond bit `at`, in one direction.
FORMULA int cells_alike(uint cells, int at, int way) {
  uint own = (cells >> uint(at)) & 1u;
  int n = 0;
  for (int k = 1; k <= kFloatCells; ++k) n += n == k - 1 && ((cells >> uint(at + k * way)) & 1u) == own ? 1 : 0;
  return n;
}

// Of a thread where it crosses thread `crossing` of the other system, which is bit `at` of its cells.
FORMULA float crossing_height(ThreadGrid g, int system, int thread, ThreadSection body, int crossing, uint cells, int at) {
  ThreadSection other = thread_body(1 - system, crossing);
  vec2 spacing = g.period / vec2(float(g.count.x), float(g.count.y));   // mean, of ends, of picks
  float own_stiffness = bending_stiffness(2.0f * body.half_width, 2.0f * body.half_height, spacing[1 - system]);
  float other_stiffness = bending_stiffness(2.0f * other.half_width, 2.0f * other.half_height, spacing[system]);
  float warp_part = system == 0 ? crimp_fraction(own_stiffness, other_stiffness) : crimp_fraction(other_stiffness, own_stiffness);
  vec3 own_section = section_at(g, system, thread, body, crossing);
  vec3 other_section = section_at(g, 1 - system, crossing, other, thread);
  float apart = own_section.y + other_section.y;
  float rise = longest_rise(2.0f * body.half_width, 2.0f * body.half_height, 2.0f * body.half_room)
             * rise_of(cells_alike(cells, at, -1), cells_alike(cells, at, 1));
  bool above = (((cells >> uint(at)) & 1u) == 1u) == (system == 0);
  float height = (system == 0 ? warp_part : 1.0f - warp_part) * apart + rise;
  return above ? height : -height;
}

// Height, and slope along the thread.
FORMULA vec2 height_and_slope(ThreadGrid g, int system, int thread, int crossing) {
  ThreadSection body = thread_body(system, thread);
  uint cells = thread_cells(system, thread, crossing);
  vec2 before = beside(g, 1 - system, crossing, -1);
  vec2 after = beside(g, 1 - system, crossing, 1);
  float low = crossing_height(g, system, thread, body, int(before.x), cells, STRIP_MARGIN - 1);
  float high = crossing_height(g, system, thread, body, int(after.x), cells, STRIP_MARGIN + 1);
  return vec2(crossing_height(g, system, thread, body, crossing, cells, STRIP_MARGIN),
              centre_slope(low, high, max(after.y - before.y, kMinStep_mm)));
}

FORMULA vec4 computed_crossing(ThreadGrid g, int end, int pick) {
  return vec4(height_and_slope(g, 0, end, pick), height_and_slope(g, 1, pick, end));
}
