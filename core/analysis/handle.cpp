#include "analysis/handle.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "draft/fibre.h"
#include "draft/finish.h"

namespace weftlight::analysis {
namespace {

constexpr double kGravity = 9.81, kCrimp = 1.05;  // a thread is so much longer than the cloth
// Of the mean between free and bound fibres: cotton cloths of known bending length (shirting 18 to 20 mm, 14 oz denim
// 25).
constexpr double kCohesion = 0.38;
constexpr double kHoldingTwist = 0.05;  // tangent of the twist at which half of the cohesion is there
// A thread that stays round in the cloth is firm: raw silk in its gum, hard-twisted.
constexpr double kFirmFrom = 0.85, kFirmer = 3;

// Filament twisted so hard, and not plied against it, that its torque draws the wet cloth together: tangents of the
// twist from an organzine's, which does not, to a crepe's; how much longer than the cloth its yarn then is (widths of
// crepe de chine before and after the boil, the trade's; an estimate); unevenness (CV, %) that no filament has.
constexpr double kOrganzine = 0.2, kCrepe = 0.3, kContraction = 0.12, kFilamentUpTo = 6;

/// By preset, as yarn_presets.cpp has them: modulus in bending, N/mm2; section of a fibre, mm2; density, g/cm3.
struct FibreBody {
  double modulus, section, density;
  bool filament = false;
};
constexpr std::array<FibreBody, 8> kFibres{{{6000, 1.05e-4, 1.52},
                                            {7000, 1.1e-4, 1.52},
                                            {11000, 2.5e-4, 1.5},
                                            {8000, 1e-4, 1.34, true},
                                            {2000, 3.5e-4, 1.31},
                                            {6000, 1.1e-4, 1.52, true},
                                            {6000, 1.2e-4, 1.39, true},
                                            {4000, 5e-3, 1.39}}};

template <class T>
T entry(const std::vector<T>& table, size_t i, T missing) {
  return i < table.size() ? table[i] : missing;
}

/// Of one thread.
struct ThreadHandle {
  double g_per_m = 0, bending_n_mm2 = 0;
};

/// 0..1: stays round in the cloth, as a yarn bound through and through does.
double firmness(const Yarn& yarn) {
  return std::clamp((static_cast<double>(yarn.flattening) - kFirmFrom) / (1 - kFirmFrom), 0.0, 1.0);
}

/// Gum is boiled off in the piece, and an organdie's finish is the cloth's: where one yarn has gone flat, none is
/// bound, and what is round is so by its twist (a crepe's weft) or as it lies (a charmeuse's).
double cloth_firmness(const Design& design) {
  double firm = 1;
  for (const System system : {System::kWarp, System::kWeft})
    for (const int yarn : design.draft.threads(system).yarn)
      if (const auto y = static_cast<size_t>(std::max(yarn, 0)); y < design.yarns.size())
        firm = std::min(firm, firmness(design.yarns[y]));
  return firm;
}

/// 0..1: of a crepe, whose filaments lie loose in its waves: torque has gone with the contraction, and where gum was is
/// room, so that they slide (M. Matsudaira, S. Kawabata 1988, A study of the mechanical properties of woven silk
/// fabrics).
double crepe_share(const Yarn& yarn, const FibreBody& fibre, double lean) {
  const bool filament = fibre.filament && yarn.plies == 1 && static_cast<double>(yarn.unevenness) < kFilamentUpTo;
  return filament ? std::clamp((lean - kOrganzine) / (kCrepe - kOrganzine), 0.0, 1.0) : 0;
}

ThreadHandle thread_handle(Yarn yarn, float thickness_mm, double firm) {
  const double tex = static_cast<double>(thickness_mm >= 0 ? tex_of(yarn, thickness_mm) : tex_of(yarn));
  if (thickness_mm >= 0) yarn.diameter_mm = thickness_mm;
  const FibreBody& fibre = kFibres[static_cast<size_t>(fibre_of(yarn))];
  const double area = tex / (1000 * fibre.density);
  const double fibres = std::max(area / fibre.section, 1.0);
  const double lean = std::numbers::pi * static_cast<double>(yarn.diameter_mm * yarn.turns_per_m) / 1000;
  const double held = kCohesion * std::sqrt(fibres) * (1 + (kFirmer - 1) * firm);
  const double crepe = crepe_share(yarn, fibre, lean) * (1 - firm), path = 1 + kContraction * crepe;
  const double bound = std::max((1 - crepe) * lean / (lean + kHoldingTwist), firm);
  const double cohesion = 1 + std::max(held - 1, 0.0) * bound;
  return {path * tex / 1000, fibre.modulus * area * fibre.section / (4 * std::numbers::pi) * cohesion / path};
}

/// Sums over a system's threads, and their extent.
struct SystemHandle {
  double g_per_m = 0, bending_n_mm2 = 0, extent_mm = 0, height_mm = 0;
};

SystemHandle system_handle(const Design& design, System system, double firm) {
  const Threads& threads = design.draft.threads(system);
  SystemHandle sum;
  const size_t count = threads.color.size();
  if (design.yarns.empty()) return sum;
  std::vector<ThreadHandle> known(design.yarns.size());
  for (size_t y = 0; y < known.size(); ++y) known[y] = thread_handle(design.yarns[y], -1, firm);
  float last = -1;
  size_t last_yarn = 0;
  ThreadHandle given_hand;
  for (size_t i = 0; i < count; ++i) {
    const size_t index = std::min(static_cast<size_t>(std::max(entry(threads.yarn, i, 0), 0)), known.size() - 1);
    const Yarn& yarn = design.yarns[index];
    const float given = entry(threads.thickness_mm, i, kFromYarn), spacing = entry(threads.spacing_mm, i, kFromYarn);
    const float thick = given >= 0 ? given : yarn.diameter_mm;
    if (given >= 0 && (given != last || index != last_yarn))
      given_hand = thread_handle(yarn, given, firm), last = given, last_yarn = index;
    const ThreadHandle& hand = given >= 0 ? given_hand : known[index];
    sum.g_per_m += hand.g_per_m, sum.bending_n_mm2 += hand.bending_n_mm2;
    sum.extent_mm += static_cast<double>(spacing > 0 ? spacing : thick);
    sum.height_mm += static_cast<double>(thick * std::sqrt(std::clamp(yarn.flattening, 0.3f, 1.0f)));
  }
  sum.height_mm /= static_cast<double>(std::max<size_t>(count, 1));
  return sum;
}

}  // namespace

ClothHandle cloth_handle(const Design& design) {
  const double firm = cloth_firmness(design);
  const SystemHandle warp = system_handle(design, System::kWarp, firm),
                     weft = system_handle(design, System::kWeft, firm);
  ClothHandle hand;
  if (!(warp.extent_mm > 0) || !(weft.extent_mm > 0)) return hand;
  hand.kg_per_m2 = kCrimp * (warp.g_per_m / warp.extent_mm + weft.g_per_m / weft.extent_mm);
  // N mm2 a mm are N mm; a thousandth of it is N m.
  hand.bending_n_m = 1e-3 * std::sqrt(warp.bending_n_mm2 / warp.extent_mm * (weft.bending_n_mm2 / weft.extent_mm));
  hand.thickness_mm = warp.height_mm + weft.height_mm;
  if (hand.kg_per_m2 > 0) hand.bending_length_mm = 1e3 * std::cbrt(hand.bending_n_m / (hand.kg_per_m2 * kGravity));
  return hand;
}

}  // namespace weftlight::analysis
