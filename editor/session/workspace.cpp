#include "session/workspace.h"

#include <algorithm>
#include <cmath>

namespace weftlight::session {
namespace {

constexpr float kSmallestPitch = 0.02f;  // 100,000 threads in 2,000 pixels
constexpr float kLargestPitch = 48.0f;

}  // namespace

float zoomed_pitch(float pitch, float steps) {
  float next = pitch * std::pow(1.2f, steps);
  if (next >= 2) {
    next = std::round(next);
    if (next == pitch && steps != 0) next += steps > 0 ? 1.0f : -1.0f;
  }
  return std::clamp(next, kSmallestPitch, kLargestPitch);
}

void page_ends(Workspace& w, int pages) {
  w.scroll_end += static_cast<float>(pages) * std::max(1.0f, 0.9f * w.seen_ends);
}

void page_picks(Workspace& w, int pages) {
  w.scroll_pick += static_cast<float>(pages) * std::max(1.0f, 0.9f * w.seen_picks);
}

void scroll_to(Workspace& w, System system, int thread) {
  const bool warp = system == System::kWarp;
  (warp ? w.scroll_end : w.scroll_pick) =
      static_cast<float>(thread) + 0.5f - 0.5f * (warp ? w.seen_ends : w.seen_picks);
}

}  // namespace weftlight::session
