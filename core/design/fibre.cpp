#include "design/fibre.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/words.h"
#include "design/count.h"
#include "design/yarn_fields.h"
#include "design/yarn_presets.h"

namespace weftlight::design {

using base::same_word;

namespace {

// Ratio of the highlight's width along the fibre between dull and bright, as between matt (delustred with titanium
// dioxide) and bright filaments of one polymer. The layers change by its square root.
constexpr float kLustreRange = 9.0f;

/// By preset, in the order of yarn_presets.cpp: density of the fibre, g/cm3; packing of the thread where no count is
/// set. For metallic yarn those of the film.
struct Substance {
  double density, packing;
};
constexpr std::array<Substance, kFibres> kSubstances{
    {{1.52, 0.6}, {1.52, 0.65}, {1.5, 0.65}, {1.34, 0.6}, {1.31, 0.5}, {1.52, 0.6}, {1.39, 0.6}, {1.39, 0.6}}};

/// Factors relative to a round fibre: spread of the reflected light along and across, reflecting layers, inner scatter,
/// transmission, path through the dye. Flat sides reflect light in one direction, and lobes reflect what would be
/// transmitted (W. E. Morton and J. W. S. Hearle, Physical Properties of Textile Fibres, ch. 25); cotton's bean twists
/// along its length and is duller the less round it is (Adderley 1924, there). By rank, except the depth: the mean
/// chord, pi area / perimeter (Cauchy), over that of a circle of the same area. Trilobal: r = 1 + cos(3 a) / 3; bean:
/// cotton of maturity 0.58; film: 12 by 370 um.
struct Shape {
  float along, across, layers, inner, transmission, depth;
};
constexpr std::array<Shape, kCrossSectionNames.size()> kShapes{{{1, 1, 1, 1, 1, 1},
                                                                {1, 0.8f, 1.35f, 1.25f, 0.7f, 0.84f},
                                                                {1.35f, 1.15f, 0.75f, 0.9f, 0.9f, 0.76f},
                                                                {0.85f, 0.35f, 1, 0.7f, 1.2f, 0.31f}}};

const Shape& shape_of(CrossSection s) { return kShapes[static_cast<size_t>(s)]; }

const Substance& substance_of(const Yarn& yarn) { return kSubstances[static_cast<size_t>(yarn.fibre)]; }

/// Count of a thread of this diameter that is solid fibre.
double solid_tex(const Yarn& yarn, float diameter_mm) {
  return tex_from_diameter(static_cast<double>(diameter_mm), substance_of(yarn).density, 1);
}

constexpr float kFar = 1e30f;

/// Dissimilarity by the parameters that tell fibres apart and that no slider of a weaver changes: index of refraction,
/// specular strength, spread across, inner scatter, transmission, fibre bundles, fuzz. Each term saturates, as fits to
/// measured cloths and finishes move single parameters far and leave the others as in the preset.
float dissimilarity(const Yarn& a, const Yarn& b) {
  const auto octaves = [](float x, float y) { return std::log2((x + 0.01f) / (y + 0.01f)); };
  const auto saturating = [](float off) { return off * off / (1 + off * off); };
  return (a.lobes.metallic != b.lobes.metallic ? 1e6f : 0) + 2 * saturating(60 * (a.lobes.ior - b.lobes.ior)) +
         saturating(5 * (a.lobes.inner - b.lobes.inner)) +
         saturating(octaves(a.lobes.across_width, b.lobes.across_width)) + saturating(octaves(a.fibre_um, b.fibre_um)) +
         saturating(4 * (a.groove_depth - b.groove_depth)) + saturating(8 * (a.lobes.specular - b.lobes.specular)) +
         saturating(20 * (a.lobes.transmission - b.lobes.transmission)) +
         saturating(10 * (a.lobes.fuzz_width - b.lobes.fuzz_width)) +
         2 * saturating(6 * octaves(a.lobes.inner_depth, b.lobes.inner_depth));
}

/// The lobes with the factors of one cross-section replaced by those of another.
Lobes reshaped(Lobes lobes, const Shape& from, const Shape& to) {
  lobes.along_width *= to.along / from.along;
  lobes.across_width *= to.across / from.across;
  lobes.layers = 1 + (lobes.layers - 1) * to.layers / from.layers;
  lobes.inner *= to.inner / from.inner;
  lobes.transmission *= to.transmission / from.transmission;
  lobes.inner_depth *= to.depth / from.depth;
  return clamped(lobes);
}

/// A yarn of this cross-section.
Yarn in_section(Yarn yarn, CrossSection section) {
  if (section != yarn.section) yarn.lobes = reshaped(yarn.lobes, shape_of(yarn.section), shape_of(section));
  yarn.section = section;
  return yarn;
}

struct NearestSection {
  CrossSection section = CrossSection::kRound;
  float distance = kFar;  // dissimilarity
};

/// What ready yarns had before their lobes followed from their fibres: files from then may name no fibre.
struct EarlierLobes {
  Fibre fibre;
  float across_width, inner;
};
constexpr EarlierLobes kEarlierLobes[]{{Fibre::kSilk, 0.89f, 0.09f},
                                       {Fibre::kWool, 0.6f, 0.1f},
                                       {Fibre::kViscose, 0.6f, 0.1f},
                                       {Fibre::kPolyester, 0.69f, 0.02f}};

NearestSection nearest_section(const Yarn& yarn, Fibre fibre) {
  NearestSection nearest;
  const auto try_lobes = [&](Yarn ready) {
    for (int s = 0; s < kCrossSections; ++s) {
      const auto section = static_cast<CrossSection>(s);
      const float distance = dissimilarity(yarn, in_section(ready, section));
      if (distance < nearest.distance) nearest = {section, distance};
    }
  };
  try_lobes(ready_yarn(fibre));
  for (const EarlierLobes& earlier : kEarlierLobes) {
    if (earlier.fibre != fibre) continue;
    Yarn ready = ready_yarn(fibre);
    ready.lobes.across_width = earlier.across_width, ready.lobes.inner = earlier.inner;
    try_lobes(std::move(ready));
  }
  return nearest;
}

Yarn usual(const Yarn& yarn) { return in_section(ready_yarn(yarn.fibre), yarn.section); }

}  // namespace

std::optional<Fibre> fibre_from_name(std::string_view name) {
  for (const Yarn& ready : yarn_presets())
    if (same_word(ready.name, name)) return ready.fibre;
  return std::nullopt;
}

std::optional<CrossSection> section_from_name(std::string_view name) {
  for (size_t s = 0; s < kCrossSectionNames.size(); ++s)
    if (same_word(kCrossSectionNames[s], name)) return static_cast<CrossSection>(s);
  return std::nullopt;
}

Yarn with_recognised_section(Yarn yarn) {
  yarn.section = nearest_section(yarn, yarn.fibre).section;
  return yarn;
}

Yarn with_recognised_fibre(Yarn yarn) {
  float least = kFar;
  for (const Yarn& ready : yarn_presets()) {
    const NearestSection nearest = nearest_section(yarn, ready.fibre);
    if (nearest.distance < least) least = nearest.distance, yarn.fibre = ready.fibre, yarn.section = nearest.section;
  }
  return yarn;
}

Yarn with_cross_section(Yarn yarn, CrossSection section) {
  if (yarn.section == section) return yarn;
  yarn.lobes = reshaped(yarn.lobes, shape_of(yarn.section), shape_of(section));
  yarn.section = section;
  yarn.lobes.inner_depth = usual(yarn).lobes.inner_depth;
  return yarn;
}

Yarn with_fibre(Yarn yarn, Fibre fibre) {
  const Yarn& from = ready_yarn(fibre);
  yarn.fibre = from.fibre, yarn.section = from.section;
  yarn.lobes = from.lobes;
  yarn.fibre_um = from.fibre_um, yarn.groove_depth = from.groove_depth, yarn.hairiness = from.hairiness;
  return yarn;
}

float lustre(const Yarn& yarn) {
  const float preset = usual(yarn).lobes.along_width, own = std::max(yarn.lobes.along_width, 1e-4f);
  return std::clamp(0.5f + std::log(preset / own) / std::log(kLustreRange), 0.0f, 1.0f);
}

Yarn with_lustre(Yarn yarn, float lustre) {
  const Lobes preset = usual(yarn).lobes;
  const float brighter = std::pow(kLustreRange, std::clamp(lustre, 0.0f, 1.0f) - 0.5f);
  yarn.lobes.along_width = preset.along_width / brighter;
  yarn.lobes.layers = 1 + (preset.layers - 1) * std::sqrt(brighter);
  return clamped(std::move(yarn));
}

Yarn with_hairiness(Yarn yarn, float hairiness) {
  const Yarn& preset = ready_yarn(yarn.fibre);
  yarn.hairiness = hairiness;
  yarn.lobes.fuzz = preset.lobes.fuzz * hairiness / std::max(preset.hairiness, 0.01f);
  return clamped(std::move(yarn));
}

float tex_of(const Yarn& yarn) {
  if (yarn.tex > 0) return yarn.tex;
  return static_cast<float>(solid_tex(yarn, yarn.diameter_mm) * substance_of(yarn).packing);
}

float tex_of(const Yarn& yarn, float thickness_mm) {
  if (!(yarn.diameter_mm > 0)) {
    Yarn thread = yarn;
    thread.diameter_mm = thickness_mm;
    return tex_of(thread);
  }
  const float ratio = thickness_mm / yarn.diameter_mm;
  return tex_of(yarn) * ratio * ratio;
}

double packing_fraction(const Yarn& yarn) {
  return yarn.diameter_mm > 0 ? static_cast<double>(tex_of(yarn)) / solid_tex(yarn, yarn.diameter_mm) : 0;
}

double spun_diameter_mm(const Yarn& yarn, float thickness_mm) {
  if (yarn.section == CrossSection::kFlat) return static_cast<double>(thickness_mm);
  const Substance& fibre = substance_of(yarn);
  return diameter_from_tex_mm(static_cast<double>(tex_of(yarn, thickness_mm)), fibre.density, fibre.packing);
}

Yarn with_thickness(Yarn yarn, float diameter_mm) {
  if (yarn.tex > 0) yarn.tex = std::round(100 * tex_of(yarn, diameter_mm)) / 100;
  yarn.diameter_mm = diameter_mm;
  return clamped(std::move(yarn));
}

std::optional<Yarn> with_count(Yarn yarn, std::string_view count) {
  if (count.find_first_not_of(" \t") == std::string_view::npos) {
    yarn.tex = 0;
    return yarn;
  }
  const std::optional<WrittenCount> written = read_count(count);
  if (!written) return std::nullopt;
  const double tex = written->tex;
  const Substance& fibre = substance_of(yarn);
  const double packing = yarn.diameter_mm > 0 ? packing_fraction(yarn) : fibre.packing;
  yarn.diameter_mm = static_cast<float>(std::round(diameter_from_tex_mm(tex, fibre.density, packing) * 1000) / 1000);
  yarn.tex = static_cast<float>(std::round(tex * 1000) / 1000);
  if (written->plies > 0) yarn.plies = written->plies;
  return clamped(std::move(yarn));
}

}  // namespace weftlight::design
