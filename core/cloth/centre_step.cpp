#include "cloth/centre_step.h"

#include <algorithm>
#include <cmath>

#include "cloth/wrap.h"

namespace weftlight::cloth {

float position_in_period(float s_mm, float period_mm) {
  return std::clamp(s_mm - std::floor(s_mm / period_mm) * period_mm, 0.0f, period_mm);
}

namespace {

/// Of the threads that a thread of a system crosses: a warp thread crosses the picks, a weft thread the ends.
struct Crossed {
  const std::vector<ThreadBody>& threads;
  float period;
  Crossed(const Cloth& cloth, System system)
      : threads(system == System::kWarp ? cloth.picks : cloth.ends),
        period(system == System::kWarp ? cloth.depth_mm : cloth.width_mm) {}
  float centre_mm(int i) const {
    const int n = static_cast<int>(threads.size());
    if (i >= 0 && i < n) return threads[static_cast<size_t>(i)].centre_mm;
    const float whole = std::floor(static_cast<float>(i) / static_cast<float>(n));
    return threads[static_cast<size_t>(wrap(i, n))].centre_mm + whole * period;
  }
};

/// The step from a crossing on. centre_of: position of a crossing.
template <class CentreOf>
CentreStep step_from(int crossing, float s, const CentreOf& centre_of) {
  const auto gap = [](float a, float b) { return std::max(b - a, 1e-6f); };
  const float x0 = centre_of(crossing - 1), x1 = centre_of(crossing), x2 = centre_of(crossing + 1),
              x3 = centre_of(crossing + 2);
  CentreStep step{crossing, 0, gap(x0, x1), gap(x1, x2), gap(x2, x3)};
  step.t = std::clamp((s - x1) / step.h1, 0.0f, 1.0f);
  return step;
}

}  // namespace

CentreStep centre_step(const Cloth& cloth, System system, float s_mm) {
  const Crossed crossed(cloth, system);
  const float s = position_in_period(s_mm, crossed.period);
  const auto after = std::upper_bound(crossed.threads.begin(), crossed.threads.end(), s,
                                      [](float x, const ThreadBody& t) { return x < t.centre_mm; });
  return step_from(static_cast<int>(after - crossed.threads.begin()) - 1, s,
                   [&](int i) { return crossed.centre_mm(i); });
}

float aside_at(const Cloth& cloth, System system, int thread, int crossing) {
  const std::vector<float>& aside = system == System::kWarp ? cloth.warp_aside_mm : cloth.weft_aside_mm;
  if (aside.empty()) return 0;
  const int end = wrap(system == System::kWarp ? thread : crossing, cloth.up.cols()),
            pick = wrap(system == System::kWarp ? crossing : thread, cloth.up.rows());
  return aside[static_cast<size_t>(pick) * static_cast<size_t>(cloth.up.cols()) + static_cast<size_t>(end)];
}

CentreStep moved_step(const Cloth& cloth, System system, int thread, float s_mm, const CentreStep& even) {
  if (cloth.warp_aside_mm.empty()) return even;
  const Crossed crossed(cloth, system);
  const System other = system == System::kWarp ? System::kWeft : System::kWarp;
  const auto centre_of = [&](int i) { return crossed.centre_mm(i) + aside_at(cloth, other, i, thread); };
  const float s = position_in_period(s_mm, crossed.period);
  // A thread is moved by less than half its spacing.
  int crossing = even.crossing;
  if (s < centre_of(crossing)) --crossing;
  else if (s >= centre_of(crossing + 1)) ++crossing;
  return step_from(crossing, s, centre_of);
}

}  // namespace weftlight::cloth
