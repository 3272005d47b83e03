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

/// By preset, as yarn_presets.cpp has them: density of the fibre, g/cm3; share of the thread that is fibre. Of metallic
/// yarn the film's.
struct Substance {
  double density, packing;
};
constexpr std::array<Substance, 8> kSubstances{
    {{1.52, 0.6}, {1.52, 0.65}, {1.5, 0.65}, {1.34, 0.6}, {1.31, 0.5}, {1.52, 0.6}, {1.39, 0.6}, {1.39, 0.6}}};

const Substance& substance_of(const Yarn& yarn) { return kSubstances[static_cast<size_t>(fibre_of(yarn))]; }

const Yarn& preset_of(int preset) {
  const auto all = yarn_presets();
  return all[static_cast<size_t>(std::clamp(preset, 0, static_cast<int>(all.size()) - 1))];
}

/// Of what tells fibres apart and no slider of a weaver's moves: index, strength, how they lie across, inner light,
/// what passes through, bundles.
float unlikeness(const Yarn& a, const Yarn& b) {
  const auto octaves = [](float x, float y) { return std::log2((x + 0.01f) / (y + 0.01f)); };
  const float index = 40 * (a.lobes.ior - b.lobes.ior), inner = 5 * (a.lobes.inner - b.lobes.inner),
              across = octaves(a.lobes.across_width, b.lobes.across_width),
              bundle = 0.4f * octaves(a.fibre_um, b.fibre_um), groove = 2 * (a.groove_depth - b.groove_depth),
              specular = 8 * (a.lobes.specular - b.lobes.specular),
              through = 20 * (a.lobes.transmission - b.lobes.transmission);
  return (a.lobes.metallic != b.lobes.metallic ? 1e6f : 0) + index * index + inner * inner + across * across +
         bundle * bundle + groove * groove + specular * specular + through * through;
}

}  // namespace

/// Share of the thread that is fibre. A yarn that is hairier than its ready one is spun or brushed loftier, and its
/// thickness is in part that of the hairs: woollen of Nm 5.6 stands 0.93 mm thick, a fifth of it fibre.
double packing_of(const Yarn& yarn) {
  constexpr double kLoftier = 0.6;  // of the share, lost where all is hair
  const double usual = static_cast<double>(preset_of(fibre_of(yarn)).hairiness);
  const double more = std::clamp((static_cast<double>(yarn.hairiness) - usual) / std::max(1 - usual, 0.01), 0.0, 1.0);
  return substance_of(yarn).packing * (1 - kLoftier * more);
}

int fibre_of(const Yarn& yarn) {
  const auto all = yarn_presets();
  const auto at = std::ranges::min_element(all, {}, [&](const Yarn& y) { return unlikeness(yarn, y); });
  return static_cast<int>(at - all.begin());
}

Yarn with_fibre(Yarn yarn, int preset) {
  const Yarn& of = preset_of(preset);
  yarn.lobes = of.lobes;
  yarn.fibre_um = of.fibre_um, yarn.groove_depth = of.groove_depth, yarn.hairiness = of.hairiness;
  return yarn;
}

float lustre(const Yarn& yarn) {
  const float usual = preset_of(fibre_of(yarn)).lobes.along_width, own = std::max(yarn.lobes.along_width, 1e-4f);
  return std::clamp(0.5f + std::log(usual / own) / std::log(kLustreRange), 0.0f, 1.0f);
}

Yarn with_lustre(Yarn yarn, float lustre) {
  const Lobes& usual = preset_of(fibre_of(yarn)).lobes;
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
  const double packing = packing_of(yarn);
  return static_cast<float>(
      tex_from_diameter(static_cast<double>(yarn.diameter_mm), substance_of(yarn).density, packing));
}

std::optional<Yarn> with_count(Yarn yarn, std::string_view count) {
  const std::optional<double> tex = tex_from_text(count);
  if (!tex) return std::nullopt;
  const double diameter_mm = diameter_from_tex_mm(*tex, substance_of(yarn).density, packing_of(yarn));
  yarn.diameter_mm = static_cast<float>(std::round(diameter_mm * 1000) / 1000);
  return clamped(std::move(yarn));
}

}  // namespace weftlight::draft
