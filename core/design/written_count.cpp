#include "design/written_count.h"

#include "design/count.h"
#include "design/fibre.h"

namespace weftlight::design {

namespace {

/// In which the trade counts such a yarn. Filament has almost no free fibre ends, spun silk and polyester have some.
CountUnit trade_unit(const Yarn& yarn) {
  using enum CountUnit;
  constexpr float kMostOfFilament = 0.05f;  // hairiness
  const bool filament = yarn.hairiness <= kMostOfFilament;
  switch (yarn.fibre) {
    case Fibre::kCotton:
    case Fibre::kMercerisedCotton:
      return kNe;
    case Fibre::kLinen:
      return kLea;
    case Fibre::kSilk:
      return filament ? kDenier : kNm;
    case Fibre::kWool:
      return kNm;
    case Fibre::kViscose:
    case Fibre::kPolyester:
      return filament ? kDenier : kNe;
    case Fibre::kMetallic:
      return kTex;
  }
  return kTex;
}

}  // namespace

std::string written_count(const Yarn& yarn) {
  const auto tex = static_cast<double>(tex_of(yarn));
  const CountUnit unit = trade_unit(yarn);
  return yarn.tex > 0 ? count_text(tex, yarn.plies, unit) : about_count_text(tex, yarn.plies, unit);
}

}  // namespace weftlight::design
