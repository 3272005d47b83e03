#include "design/yarn_fields.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "design/dye.h"

namespace weftlight::design {

using draft::Rgb;

namespace {

float clamped_or(float value, float low, float high, float fallback) {
  return std::isnan(value) ? fallback : std::clamp(value, low, high);
}

Rgb clamped_tint(Rgb c) { return {clamped_or(c.r, 0, 1, 1), clamped_or(c.g, 0, 1, 1), clamped_or(c.b, 0, 1, 1)}; }

template <class T, size_t N>
void clamp_fields(T& value, const std::array<YarnField<T>, N>& fields) {
  const T defaults;
  for (const YarnField<T>& f : fields)
    value.*f.member = clamped_or(value.*f.member, f.facts.low, f.facts.high, defaults.*f.member);
}

}  // namespace

Lobes clamped(Lobes lobes) {
  clamp_fields(lobes, kLobeFields);
  lobes.specular_tint = clamped_tint(lobes.specular_tint);
  return lobes;
}

Yarn clamped(Yarn yarn) {
  clamp_fields(yarn, kYarnFields);
  yarn.plies = std::clamp(yarn.plies, static_cast<int>(kPliesFacts.low), static_cast<int>(kPliesFacts.high));
  yarn.lobes = clamped(yarn.lobes);
  yarn.dye = clamped(std::move(yarn.dye));
  return yarn;
}

}  // namespace weftlight::design
