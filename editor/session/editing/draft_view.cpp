#include "session/editing/draft_view.h"

#include <algorithm>
#include <cmath>

namespace weftlight::session {
namespace {

constexpr float kSmallestPitch = 0.02f;  // 100,000 threads in 2,000 pixels
constexpr float kLargestPitch = 48.0f;

}  // namespace

bool is_fitted(const DraftView& v) { return v.pitch <= 0 || v.pitch == v.fitted_pitch; }

void fit_grown(DraftView& v) {
  if (v.has_grown && is_fitted(v)) v.pitch = 0;
  v.has_grown = false;
}

float zoomed_pitch(float pitch, float steps) {
  float next = pitch * std::pow(1.2f, steps);
  if (next >= 2) {
    next = std::round(next);
    if (next == pitch && steps != 0) next += steps > 0 ? 1.0f : -1.0f;
  }
  return std::clamp(next, kSmallestPitch, kLargestPitch);
}

float smallest_pitch(const DraftView& v, int ends, int picks) {
  constexpr float kReadable = 4;  // pixels
  if (v.seen_ends <= 0 || v.seen_picks <= 0) return kSmallestPitch;
  const float fitting = v.pitch * std::min(v.seen_ends / static_cast<float>(std::max(1, ends)),
                                           v.seen_picks / static_cast<float>(std::max(1, picks)));
  return std::min(kReadable, std::max(kSmallestPitch, fitting));
}

void page_ends(DraftView& v, int pages) {
  v.scroll_end += static_cast<float>(pages) * std::max(1.0f, 0.9f * v.seen_ends);
}

void page_picks(DraftView& v, int pages) {
  v.scroll_pick += static_cast<float>(pages) * std::max(1.0f, 0.9f * v.seen_picks);
}

void bring_into_sight(DraftView& v, GridId grid, Cell at) {
  const auto see = [](float& scroll, float seen, int cell) {
    constexpr float kBeside = 1;  // cells
    const auto first = static_cast<float>(cell);
    if (seen < 2 * kBeside + 1) scroll = first;
    else scroll = std::max(0.0f, std::clamp(scroll, first + 1 + kBeside - seen, first - kBeside));
  };
  const bool ends = has_ends(grid), picks = has_picks(grid);
  see(ends ? v.scroll_end : v.scroll_treadle, ends ? v.seen_ends : v.seen_treadles, at.a);
  see(picks ? v.scroll_pick : v.scroll_shaft, picks ? v.seen_picks : v.seen_shafts, at.b);
}

void scroll_to(DraftView& v, System system, int thread) {
  const bool warp = system == System::kWarp;
  (warp ? v.scroll_end : v.scroll_pick) =
      static_cast<float>(thread) + 0.5f - 0.5f * (warp ? v.seen_ends : v.seen_picks);
}

}  // namespace weftlight::session
