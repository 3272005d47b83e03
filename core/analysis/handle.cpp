#include "analysis/handle.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "design/fibre.h"
#include "design/finish.h"

namespace weftlight::analysis {

using design::Yarn, design::tex_of;
using draft::System, draft::Threads, draft::kFromYarn;

namespace {

constexpr double kGravity = 9.81, kCrimp = 1.05;  // length of a thread over that of the cloth
// Factor on the geometric mean of free and bound fibres. Fitted to cotton cloths of known bending length (shirting 18
// to 20 mm, 14 oz denim 25 mm).
constexpr double kCohesion = 0.38;
constexpr double kHalfCohesionTwist = 0.05;  // tangent of the twist angle at half of the cohesion
// A thread that stays round in the cloth is firm: raw silk in its gum, hard-twisted yarn. Least flattening (height over
// width) of a firm thread, and the factor on its cohesion.
constexpr double kFirmFlattening = 0.85, kFirmFactor = 3;

// Crepe: single filament yarn of so much twist that its torque contracts the wet cloth. Tangents of the twist angle of
// organzine (no contraction) and of crepe (full); extra length of the yarn after contraction (estimated from the
// trade's widths of crepe de chine before and after boiling off); largest unevenness (CV, %) of a filament.
constexpr double kOrganzineTwist = 0.2, kCrepeTwist = 0.3, kContraction = 0.12, kMaxFilamentUnevenness = 6;

/// Fibre of each yarn preset, in the order of yarn_presets.cpp. Modulus in bending, N/mm2; cross-section of a fibre,
/// mm2; density, g/cm3.
struct FibreMechanics {
  double modulus, section, density;
  bool filament = false;
};
constexpr std::array<FibreMechanics, 8> kFibres{{{6000, 1.05e-4, 1.52},
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

/// Mass and bending stiffness of one thread.
struct ThreadHandle {
  double g_per_m = 0, bending_n_mm2 = 0;
};

/// 0..1: 1 for a yarn that stays round in the cloth, as its fibres are fully bound.
double firmness(const Yarn& yarn) {
  return std::clamp((static_cast<double>(yarn.flattening) - kFirmFlattening) / (1 - kFirmFlattening), 0.0, 1.0);
}

/// The smallest firmness of all yarns. Gum is boiled off in the piece, and an organdie finish covers the whole cloth:
/// if one yarn is flat, no yarn is bound, and a round one is so by its twist (crepe weft) or its floats (charmeuse).
double cloth_firmness(const Design& design) {
  double firm = 1;
  for (const System system : {System::kWarp, System::kWeft})
    for (const int yarn : design.draft.threads(system).yarn)
      if (const auto y = static_cast<size_t>(std::max(yarn, 0)); y < design.yarns.size())
        firm = std::min(firm, firmness(design.yarns[y]));
  return firm;
}

/// 0..1: how far the yarn is a crepe yarn, whose filaments lie loose in its waves. Contraction has released the torque
/// and the gum has left gaps, so that filaments slide (M. Matsudaira, S. Kawabata 1988, A study of the mechanical
/// properties of woven silk fabrics). `twist`: tangent of its angle.
double crepe_fraction(const Yarn& yarn, const FibreMechanics& fibre, double twist) {
  const bool filament =
      fibre.filament && yarn.plies == 1 && static_cast<double>(yarn.unevenness) < kMaxFilamentUnevenness;
  return filament ? std::clamp((twist - kOrganzineTwist) / (kCrepeTwist - kOrganzineTwist), 0.0, 1.0) : 0;
}

ThreadHandle thread_handle(Yarn yarn, float thickness_mm, double firm) {
  const double tex = static_cast<double>(thickness_mm >= 0 ? tex_of(yarn, thickness_mm) : tex_of(yarn));
  if (thickness_mm >= 0) yarn.diameter_mm = thickness_mm;
  const FibreMechanics& fibre = kFibres[static_cast<size_t>(yarn.fibre)];
  const double area = tex / (1000 * fibre.density);
  const double fibres = std::max(area / fibre.section, 1.0);
  const double twist = std::numbers::pi * static_cast<double>(yarn.diameter_mm * yarn.turns_per_m) / 1000;
  const double full_cohesion = kCohesion * std::sqrt(fibres) * (1 + (kFirmFactor - 1) * firm);
  const double crepe = crepe_fraction(yarn, fibre, twist) * (1 - firm), path = 1 + kContraction * crepe;
  const double bound = std::max((1 - crepe) * twist / (twist + kHalfCohesionTwist), firm);
  const double cohesion = 1 + std::max(full_cohesion - 1, 0.0) * bound;
  return {path * tex / 1000, fibre.modulus * area * fibre.section / (4 * std::numbers::pi) * cohesion / path};
}

/// Sums over the threads of a system, and their extent.
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
  ThreadHandle given_handle;
  for (size_t i = 0; i < count; ++i) {
    const size_t index = std::min(static_cast<size_t>(std::max(entry(threads.yarn, i, 0), 0)), known.size() - 1);
    const Yarn& yarn = design.yarns[index];
    const float given = entry(threads.thickness_mm, i, kFromYarn), spacing = entry(threads.spacing_mm, i, kFromYarn);
    const float thick = given >= 0 ? given : yarn.diameter_mm;
    if (given >= 0 && (given != last || index != last_yarn))
      given_handle = thread_handle(yarn, given, firm), last = given, last_yarn = index;
    const ThreadHandle& one = given >= 0 ? given_handle : known[index];
    sum.g_per_m += one.g_per_m, sum.bending_n_mm2 += one.bending_n_mm2;
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
  ClothHandle handle;
  if (!(warp.extent_mm > 0) || !(weft.extent_mm > 0)) return handle;
  handle.kg_per_m2 = kCrimp * (warp.g_per_m / warp.extent_mm + weft.g_per_m / weft.extent_mm);
  // N mm2 per mm of width are N mm; 1e-3 of that is N m.
  handle.bending_n_m = 1e-3 * std::sqrt(warp.bending_n_mm2 / warp.extent_mm * (weft.bending_n_mm2 / weft.extent_mm));
  handle.thickness_mm = warp.height_mm + weft.height_mm;
  if (handle.kg_per_m2 > 0)
    handle.bending_length_mm = 1e3 * std::cbrt(handle.bending_n_m / (handle.kg_per_m2 * kGravity));
  return handle;
}

}  // namespace weftlight::analysis
