// Where the numbers come from.
//
// Fineness: cotton 1.7 dtex (12 to 14 um), flax ultimates 3 (15 to 20 um), degummed silk 1.2 (10 to 13 um), wool of 21
// um
//   4.5, viscose and polyester filament 2.8 and 3.5 (W. E. Morton and J. W. S. Hearle, Physical Properties of Textile
//   Fibres, ch. 3; 300 den of 100 filaments, 150 den of 48). The metallic yarn's film is slit into wires of 30 um here.
// Spread: of fibre diameters, wool 20 to 25 %, cotton 15, flax more, filament a few percent (there).
// Angles: a highlight's width along a fibre, by rank: filament 3 to 5 degrees (as I. Sadeghi et al. 2013 fit to
// polyester
//   satin and silk), flax 7 (nodes), wool 8 (scales), cotton 10 (its convolutions turn it over several times a
//   millimetre). Around it: the less round, the wider.
// Bundles: technical fibres of flax, 50 to 100 um, hold some tens of ultimates before wet spinning divides them.
// Turbidity: filament is spun semi-dull, with titanium dioxide; degummed silk is a bundle of fibrils with voids between
//   them. How much of the light that scatters is by eye, so that satins of both fibres are as bright beside their
//   highlight as measured ones (docs/measured.md). Cotton, wool and flax hold next to nothing of the kind.
// Migration: fitted to scans of yarn by S. Zhao, F. Luan, K. Bala, Fitting procedural yarn models for realistic cloth
//   rendering, 2016: distances from the axis between 0.7 and 0.95 of the largest and 1, 0.1 to 1.9 ways a turn.
// Hair: ring-spun cotton has Uster H 4 to 7, worsted 6 to 9, filament none. Lengths fall off exponentially, under a
//   millimetre in the mean for cotton and longer for wool (A. Barella, A. M. Manich 1993).

#include "design/fibre_facts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "design/fibre.h"
#include "design/yarn_presets.h"

namespace weftlight::design {
namespace {

constexpr float kDegree = std::numbers::pi_v<float> / 180;

/// By preset, in the order of yarn_presets.cpp.
constexpr std::array<FibreFacts, kFibres> kFacts{{
    {1.52, 1.7f, 0.15f, 10 * kDegree, 0.30f, 1, 0.60f, 0.15f, 1.0f, 0.7f, 2.2f, false},
    {1.52, 1.7f, 0.12f, 6 * kDegree, 0.14f, 1, 0.40f, 0.12f, 1.0f, 0.5f, 1.5f, false},
    {1.50, 3.0f, 0.25f, 7 * kDegree, 0.20f, 12, 0.25f, 0.06f, 0.4f, 1.1f, 0.5f, false},
    {1.34, 1.2f, 0.08f, 4 * kDegree, 0.25f, 1, 0.25f, 0.08f, 0.6f, 0.6f, 1.0f, false, 0.3f},
    {1.31, 4.5f, 0.22f, 8 * kDegree, 0.15f, 1, 0.90f, 0.20f, 1.0f, 1.2f, 2.0f, false},
    {1.52, 2.8f, 0.05f, 5 * kDegree, 0.18f, 1, 0.12f, 0.03f, 0.3f, 0.6f, 0.8f, false, 0.3f},
    {1.39, 3.5f, 0.03f, 3 * kDegree, 0.12f, 1, 0.10f, 0.03f, 0.3f, 0.6f, 0.8f, false, 0.3f},
    {1.39, 9.8f, 0.02f, 4 * kDegree, 0.30f, 1, 0.05f, 0.02f, 0.3f, 0.6f, 0.5f, true},
}};

// Around the fibre, by cross-section: round, trilobal, bean, flat.
constexpr std::array<float, 4> kAcross{0.14f, 0.25f, 0.30f, 0.35f};

// What a yarn this smooth has is bound to it; the rest stands off, in mm a mm for a hairiness of 1.
constexpr float kBoundHairiness = 0.06f, kHairOfAll = 17;

// Of filament that is cut and spun throughout, beyond that.
constexpr float kCutHairiness = 0.2f;

}  // namespace

FibreFacts fibre_facts(const Yarn& yarn) {
  FibreFacts facts = kFacts[static_cast<size_t>(yarn.fibre)];
  const Yarn& same = ready_yarn(yarn.fibre);
  // A brighter or duller yarn of the same fibre.
  const float own = std::max(yarn.lobes.along_width, 1e-3f), usual = std::max(same.lobes.along_width, 1e-3f);
  facts.along_rad = std::clamp(facts.along_rad * own / usual, 0.02f, 0.35f);
  if (yarn.section != same.section) facts.across_rad = kAcross[static_cast<size_t>(yarn.section)];
  facts.metallic = yarn.lobes.metallic;
  // Filament lies side by side and has no hair; cut and spun, it wanders as cotton does.
  if (same.hairiness <= kBoundHairiness) {
    const FibreFacts& spun = kFacts[static_cast<size_t>(Fibre::kCotton)];
    const float cut = std::clamp((yarn.hairiness - kBoundHairiness) / kCutHairiness, 0.0f, 1.0f);
    facts.disorder = std::lerp(facts.disorder, spun.disorder, cut);
    facts.migration = std::lerp(facts.migration, spun.migration, cut);
  }
  return facts;
}

float hair_per_mm(const Yarn& yarn) { return kHairOfAll * std::max(yarn.hairiness - kBoundHairiness, 0.0f); }

float fibre_radius_mm(const FibreFacts& facts) {
  // dtex: 1e-7 g/mm; density: 1e-3 g/mm3.
  const double area_mm2 = 1e-4 * static_cast<double>(facts.fineness_dtex) / facts.density_g_cm3;
  return static_cast<float>(std::sqrt(area_mm2 / std::numbers::pi));
}

}  // namespace weftlight::design
