#include "design/written_count.h"

#include <array>

#include "design/count.h"
#include "design/fibre.h"

namespace weftlight::design {

std::string written_count(const Yarn& yarn) {
  using enum CountUnit;
  // By preset, in the order of yarn_presets.cpp.
  constexpr std::array<CountUnit, kFibres> kUsual{kNe, kNe, kLea, kNm, kNm, kDenier, kDenier, kTex};
  return count_text(static_cast<double>(tex_of(yarn)), yarn.plies, kUsual[static_cast<size_t>(yarn.fibre)]);
}

}  // namespace weftlight::design
