#include "draft/fibre.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "draft/count.h"
#include "draft/yarn_fields.h"
#include "draft/yarn_presets.h"

namespace weftlight::draft {
namespace {

// From dull to bright the highlight along the fibre is as many times narrower, as matt and bright filaments of one
// polymer are (delustred fibre: titanium dioxide); its layers follow by the root.
constexpr float kLustreRange = 9.0f;

/// By preset, as yarn_presets.cpp has them: density of the fibre, g/cm3; share of the thread that is fibre, where
/// no count is set. Of metallic yarn the film's.
struct Substance {
  double density, packing;
};
constexpr std::array<Substance, 8> kSubstances{
    {{1.52, 0.6}, {1.52, 0.65}, {1.5, 0.65}, {1.34, 0.6}, {1.31, 0.5}, {1.52, 0.6}, {1.39, 0.6}, {1.39, 0.6}}};

/// How a shape differs from the round: spread of the light that fibres mirror, layers that do, inner glow and what
/// passes. Flat sides throw light together, and lobes throw back what would pass (W. E. Morton and J. W. S. Hearle,
/// Physical Properties of Textile Fibres, ch. 25); cotton's bean turns about itself all along and is the duller the
/// less round it is (Adderley 1924, there). By rank, but for the depth: the mean chord, pi area / perimeter (Cauchy),
/// over that of a circle as large. Trilobal: r = 1 + cos(3 a) / 3; bean: cotton of maturity 0.58; film: 12 by 370 um.
struct Shape {
  float along, across, layers, inner, transmission, depth;
};
constexpr std::array<Shape, kCrossSectionNames.size()> kShapes{{{1, 1, 1, 1, 1, 1},
                                                                {1, 0.8f, 1.35f, 1.25f, 0.7f, 0.84f},
                                                                {1.35f, 1.15f, 0.75f, 0.9f, 0.9f, 0.76f},
                                                                {0.85f, 0.35f, 1, 0.7f, 1.2f, 0.31f}}};

/// Of the ready yarns, by preset.
constexpr std::array<CrossSection, 8> kReadySections{{CrossSection::kBean, CrossSection::kRound, CrossSection::kRound,
                                                      CrossSection::kTrilobal, CrossSection::kRound,
                                                      CrossSection::kRound, CrossSection::kRound, CrossSection::kFlat}};

const Shape& shape_of(CrossSection s) { return kShapes[static_cast<size_t>(s)]; }

const Substance& substance_of(const Yarn& yarn) { return kSubstances[static_cast<size_t>(fibre_of(yarn))]; }

/// Of a thread that were all fibre.
double solid_tex(const Yarn& yarn, float diameter_mm) {
  return tex_from_diameter(static_cast<double>(diameter_mm), substance_of(yarn).density, 1);
}

const Yarn& preset_of(int preset) {
  const auto all = yarn_presets();
  return all[static_cast<size_t>(std::clamp(preset, 0, static_cast<int>(all.size()) - 1))];
}

/// Of what tells fibres apart and no slider of a weaver's moves: index, strength, how they lie across, inner light,
/// what passes through and how far, bundles, hairs. One number that is far off says no more than that it is: fits to
/// measured cloths and finishes move some, and leave the others as the ready yarn had them.
float unlikeness(const Yarn& a, const Yarn& b) {
  const auto octaves = [](float x, float y) { return std::log2((x + 0.01f) / (y + 0.01f)); };
  const auto told = [](float off) { return off * off / (1 + off * off); };
  return (a.lobes.metallic != b.lobes.metallic ? 1e6f : 0) + 2 * told(60 * (a.lobes.ior - b.lobes.ior)) +
         told(5 * (a.lobes.inner - b.lobes.inner)) + told(octaves(a.lobes.across_width, b.lobes.across_width)) +
         told(octaves(a.fibre_um, b.fibre_um)) + told(4 * (a.groove_depth - b.groove_depth)) +
         told(8 * (a.lobes.specular - b.lobes.specular)) + told(20 * (a.lobes.transmission - b.lobes.transmission)) +
         told(10 * (a.lobes.fuzz_width - b.lobes.fuzz_width)) +
         2 * told(6 * octaves(a.lobes.inner_depth, b.lobes.inner_depth));
}

/// Of another shape, whatever it had.
Lobes reshaped(Lobes lobes, const Shape& from, const Shape& to) {
  lobes.along_width *= to.along / from.along;
  lobes.across_width *= to.across / from.across;
  lobes.layers = 1 + (lobes.layers - 1) * to.layers / from.layers;
  lobes.inner *= to.inner / from.inner;
  lobes.transmission *= to.transmission / from.transmission;
  lobes.inner_depth *= to.depth / from.depth;
  return clamped(lobes);
}

struct Kind {
  int preset = 0;
  CrossSection section = CrossSection::kRound;
};

Yarn usual_of(const Kind& kind) {
  Yarn yarn = preset_of(kind.preset);
  const CrossSection own = kReadySections[static_cast<size_t>(kind.preset)];
  if (kind.section != own) yarn.lobes = reshaped(yarn.lobes, shape_of(own), shape_of(kind.section));
  return yarn;
}

/// What it is most like, of all ready yarns in all shapes.
Kind kind_of(const Yarn& yarn) {
  Kind best;
  float least = 1e30f;
  for (int preset = 0; preset < static_cast<int>(kReadySections.size()); ++preset) {
    for (size_t s = 0; s < kShapes.size(); ++s) {
      const Kind kind{preset, static_cast<CrossSection>(s)};
      const float off = unlikeness(yarn, usual_of(kind));
      if (off < least) least = off, best = kind;
    }
  }
  return best;
}

}  // namespace

int fibre_of(const Yarn& yarn) { return kind_of(yarn).preset; }

CrossSection cross_section(const Yarn& yarn) { return kind_of(yarn).section; }

Yarn with_cross_section(Yarn yarn, CrossSection section) {
  const Kind kind = kind_of(yarn);
  if (kind.section == section) return yarn;
  yarn.lobes = reshaped(yarn.lobes, shape_of(kind.section), shape_of(section));
  yarn.lobes.inner_depth = usual_of({kind.preset, section}).lobes.inner_depth;
  return yarn;
}

Yarn with_fibre(Yarn yarn, int preset) {
  const Yarn& of = preset_of(preset);
  yarn.lobes = of.lobes;
  yarn.fibre_um = of.fibre_um, yarn.groove_depth = of.groove_depth, yarn.hairiness = of.hairiness;
  return yarn;
}

float lustre(const Yarn& yarn) {
  const float usual = usual_of(kind_of(yarn)).lobes.along_width, own = std::max(yarn.lobes.along_width, 1e-4f);
  return std::clamp(0.5f + std::log(usual / own) / std::log(kLustreRange), 0.0f, 1.0f);
}

Yarn with_lustre(Yarn yarn, float lustre) {
  const Lobes usual = usual_of(kind_of(yarn)).lobes;
  const float brighter = std::pow(kLustreRange, std::clamp(lustre, 0.0f, 1.0f) - 0.5f);
  yarn.lobes.along_width = usual.along_width / brighter;
  yarn.lobes.layers = 1 + (usual.layers - 1) * std::sqrt(brighter);
  return clamped(std::move(yarn));
}

Yarn with_hairiness(Yarn yarn, float hairiness) {
  const Yarn& usual = preset_of(fibre_of(yarn));
  yarn.hairiness = hairiness;
  yarn.lobes.fuzz = usual.lobes.fuzz * hairiness / std::max(usual.hairiness, 0.01f);
  return clamped(std::move(yarn));
}

float tex_of(const Yarn& yarn) {
  if (yarn.tex > 0) return yarn.tex;
  return static_cast<float>(solid_tex(yarn, yarn.diameter_mm) * substance_of(yarn).packing);
}

float tex_of(const Yarn& yarn, float thickness_mm) {
  if (!(yarn.diameter_mm > 0)) {
    Yarn so_thick = yarn;
    so_thick.diameter_mm = thickness_mm;
    return tex_of(so_thick);
  }
  const float ratio = thickness_mm / yarn.diameter_mm;
  return tex_of(yarn) * ratio * ratio;
}

double packing_fraction(const Yarn& yarn) {
  return yarn.diameter_mm > 0 ? static_cast<double>(tex_of(yarn)) / solid_tex(yarn, yarn.diameter_mm) : 0;
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
  const std::optional<double> tex = tex_from_text(count);
  if (!tex) return std::nullopt;
  const Substance& fibre = substance_of(yarn);
  const double share = yarn.diameter_mm > 0 ? packing_fraction(yarn) : fibre.packing;
  yarn.diameter_mm = static_cast<float>(std::round(diameter_from_tex_mm(*tex, fibre.density, share) * 1000) / 1000);
  yarn.tex = static_cast<float>(std::round(*tex * 1000) / 1000);
  return clamped(std::move(yarn));
}

}  // namespace weftlight::draft
