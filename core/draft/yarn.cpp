#include "draft/yarn.h"

#include <algorithm>
#include <cmath>

#include "draft/yarn_fields.h"

namespace weftlight::draft {
namespace {

float held(float value, float low, float high, float fallback) {
  return std::isnan(value) ? fallback : std::clamp(value, low, high);
}

Rgb held_unit(Rgb c) { return {held(c.r, 0, 1, 1), held(c.g, 0, 1, 1), held(c.b, 0, 1, 1)}; }

template <class T, size_t N>
void hold(T& value, const std::array<YarnField<T>, N>& fields) {
  const T usual;
  for (const YarnField<T>& f : fields)
    value.*f.member = held(value.*f.member, f.facts.low, f.facts.high, usual.*f.member);
}

}  // namespace

Lobes clamped(Lobes lobes) {
  hold(lobes, kLobeFields);
  lobes.specular_tint = held_unit(lobes.specular_tint);
  return lobes;
}

Yarn clamped(Yarn yarn) {
  hold(yarn, kYarnFields);
  yarn.plies = std::clamp(yarn.plies, static_cast<int>(kPliesFacts.low), static_cast<int>(kPliesFacts.high));
  yarn.lobes = clamped(yarn.lobes);
  return yarn;
}

}  // namespace weftlight::draft
