#include "cloth/centre_step.h"

#include <algorithm>
#include <cmath>

namespace weftlight::cloth {

namespace {

int wrap(int i, int n) {
  const int r = i % n;
  return r < 0 ? r + n : r;
}

}  // namespace

float position_in_period(float s_mm, float period_mm) {
  return std::clamp(s_mm - std::floor(s_mm / period_mm) * period_mm, 0.0f, period_mm);
}

CentreStep centre_step(const Cloth& cloth, System system, float s_mm) {
  // A warp thread crosses the picks, a weft thread the ends.
  const auto& crossed = system == System::kWarp ? cloth.picks : cloth.ends;
  const float period = system == System::kWarp ? cloth.depth_mm : cloth.width_mm;
  const int n = static_cast<int>(crossed.size());
  const float s = position_in_period(s_mm, period);
  const auto after =
      std::upper_bound(crossed.begin(), crossed.end(), s, [](float x, const ThreadBody& t) { return x < t.centre_mm; });
  const auto centre_mm_of = [&](int i) {
    const float whole = std::floor(static_cast<float>(i) / static_cast<float>(n));
    return crossed[static_cast<size_t>(wrap(i, n))].centre_mm + whole * period;
  };
  CentreStep step;
  step.crossing = static_cast<int>(after - crossed.begin()) - 1;
  const float x0 = centre_mm_of(step.crossing - 1), x1 = centre_mm_of(step.crossing);
  const float x2 = centre_mm_of(step.crossing + 1), x3 = centre_mm_of(step.crossing + 2);
  const auto gap = [](float a, float b) { return std::max(b - a, 1e-6f); };
  step.h0 = gap(x0, x1), step.h1 = gap(x1, x2), step.h2 = gap(x2, x3);
  step.t = std::clamp((s - x1) / step.h1, 0.0f, 1.0f);
  return step;
}

}  // namespace weftlight::cloth
