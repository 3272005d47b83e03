#include <algorithm>
#include <span>

#include "cloth/centre_step.h"
#include "cloth/layers.h"

namespace weftlight::cloth {

namespace {

/// The threads that a thread crosses: those of the other system in its layer.
std::span<const ThreadBody> crossed_by(const Cloth& cloth, System system, int thread) {
  const std::vector<ThreadBody>& all = system == System::kWarp ? cloth.picks : cloth.ends;
  if (cloth.layers.empty()) return all;
  const ClothLayer& l = cloth.layers[static_cast<size_t>(layer_of(cloth, system, thread))];
  return system == System::kWarp
             ? std::span(all).subspan(static_cast<size_t>(l.first_pick), static_cast<size_t>(l.picks))
             : std::span(all).subspan(static_cast<size_t>(l.first_end), static_cast<size_t>(l.ends));
}

}  // namespace

const ThreadBody& crossed_at(const Cloth& cloth, System system, int thread, float along_mm) {
  const std::span<const ThreadBody> crossed = crossed_by(cloth, system, thread);
  const float at = position_in_period(along_mm, system == System::kWarp ? cloth.depth_mm : cloth.width_mm);
  const auto ends_before = [](const ThreadBody& t, float mm) { return t.centre_mm + 0.5f * t.spacing_mm <= mm; };
  const auto here = std::lower_bound(crossed.begin(), crossed.end(), at, ends_before);
  return here == crossed.end() ? crossed.back() : *here;
}

}  // namespace weftlight::cloth
