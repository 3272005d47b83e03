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

}  // namespace weftlight::session
