// Where the numbers come from.
//
// Diameter: of a round thread of the count named below, d = 2 sqrt(tex / (1000 pi rho phi)) mm, with the
//   density rho of the fibre and the packing phi, the fraction of the thread that is fibre. rho, g/cm3: cotton 1.52,
//   flax 1.50, silk 1.34, wool 1.31, viscose 1.52, polyester 1.39 (W. E. Morton and J. W. S. Hearle, Physical
//   Properties of Textile Fibres, ch. 5). phi: spun yarn 0.5 (woollen) to 0.65 (hard twisted), filament 0.6.
// Turns: of the last twist, from the angle alpha that the fibres lie at on the surface,
//   T = 1000 tan(alpha) / (pi d). Spun cotton 20-25 degrees, worsted about 18, linen about 16, silk about 14,
//   filament with a producer's twist under 5 (J. W. S. Hearle, P. Grosberg, S. Backer, Structural Mechanics
//   of Fibers, Yarns, and Fabrics, 1969, on twist factors).
// Plies: two for what weavers buy as a plied warp, one for the rest.
// Grooves: width of the fibre bundles between them, some fibres wide. Fibres: cotton 12-20, flax
//   ultimates 15-20 in technical fibres of 50-100, silk 10-13, wool 20-25, filaments 12-18 um (Morton and Hearle,
//   ch. 3). Deep where bundles stay separate (linen), shallow in smooth filament.
// Hairiness: rank of the Uster hairiness of such yarns, wool over cotton over gassed cotton; filament has
//   almost no free fibre ends.
// Flattening: after weaving and pressing: Peirce 1937 found 0.6-0.8 in cotton; low twist spreads more.
// Unevenness: medians of such yarns in the Uster Statistics, that of the singles over the square root of the plies;
//   filament 1.
// Index of refraction: mean of the two of the fibre: cotton 1.578/1.532, flax 1.596/1.528, silk 1.591/1.538, wool
//   1.556/1.547, viscose 1.539/1.519, polyester 1.725/1.537 (Morton and Hearle, ch. 24).
// Lobes of cotton, linen, silk and polyester filament: widths, layers, inner part and fuzz were fitted to measured
//   cloths (tests/measured, docs/measured.md): cotton to denim and twill, linen to a plain weave, silk to charmeuse,
//   polyester to satin charmeuse. They lie near the tangents of the widths that I. Sadeghi, O. Bisker, J. De Deken,
//   H. W. Jensen, A Practical Microcylinder Appearance Model for Cloth Rendering, 2013, give for threads: linen 12
//   (surface) and 24 (volume), silk 5 and 10, polyester satin 2.5 and 5 degrees.
// Lobes of the others: by rank. Mercerising swells cotton round and smooth; viscose is filament like silk; wool has
//   scales.
// Transmission: by eye, in the order of the fibres' lustre; delustred fibre scatters most inside.
// Metallic: aluminium under a clear lacquer on a slit film of about 1/69 inch (the common count), wound or
//   laid flat: a ribbon, specular along its length, no body. The index is that of the lacquer.

#include "design/yarn_presets.h"

#include <array>

#include "base/mark.h"

namespace weftlight::design {

using base::mark;

namespace {

/// Fields that are absent have the default of yarn.h.
std::array<Yarn, kFibres> make_presets() {
  return {{
      // Ne 8/2 ring-spun, 148 tex, phi 0.6; 22 degrees.
      {
          .name = mark("Cotton"),
          .diameter_mm = 0.45f,
          .twist = Twist::kS,
          .turns_per_m = 285,
          .plies = 2,
          .fibre_um = 60,
          .groove_depth = 0.45f,
          .hairiness = 0.35f,
          .flattening = 0.70f,
          .unevenness = 11,
          .lobes =
              {
                  .specular = 1.0f,
                  .ior = 1.55f,
                  .along_width = 0.30f,
                  .across_width = 0.20f,
                  .layers = 3,
                  .inner = 0.10f,
                  .body = 0.9f,
                  .fuzz = 0.12f,
                  .fuzz_width = 0.55f,
                  .transmission = 0.12f,
              },
          .tex = 147.6f,
      },
      // Ne 10/2 gassed, 118 tex, phi 0.65; 20 degrees.
      {
          .name = mark("Mercerised cotton"),
          .fibre = Fibre::kMercerisedCotton,
          .section = CrossSection::kRound,
          .diameter_mm = 0.39f,
          .twist = Twist::kS,
          .turns_per_m = 297,
          .plies = 2,
          .fibre_um = 40,
          .groove_depth = 0.35f,
          .hairiness = 0.10f,
          .flattening = 0.75f,
          .unevenness = 9,
          .lobes =
              {
                  .specular = 1.0f,
                  .ior = 1.55f,
                  .along_width = 0.16f,
                  .across_width = 0.30f,
                  .layers = 4,
                  .inner = 0.12f,
                  .body = 0.9f,
                  .fuzz = 0.06f,
                  .fuzz_width = 0.45f,
                  .transmission = 0.12f,
              },
          .tex = 118.1f,
      },
      // Lea 16/2 wet-spun, 207 tex, phi 0.65; 16 degrees.
      {
          .name = mark("Linen"),
          .fibre = Fibre::kLinen,
          .section = CrossSection::kRound,
          .diameter_mm = 0.52f,
          .twist = Twist::kS,
          .turns_per_m = 176,
          .plies = 2,
          .fibre_um = 90,
          .groove_depth = 0.55f,
          .hairiness = 0.22f,
          .flattening = 0.75f,
          .unevenness = 18,
          .lobes =
              {
                  .specular = 1.0f,
                  .ior = 1.56f,
                  .along_width = 0.38f,
                  .across_width = 0.30f,
                  .layers = 4.4f,
                  .inner = 0.40f,
                  .body = 0.9f,
                  .fuzz = 0.02f,
                  .fuzz_width = 0.50f,
                  .transmission = 0.14f,
              },
          .tex = 206.7f,
      },
      // Nm 30/2 spun, 67 tex, phi 0.6; 14 degrees.
      {
          .name = mark("Silk"),
          .fibre = Fibre::kSilk,
          .section = CrossSection::kTrilobal,
          .diameter_mm = 0.33f,
          .twist = Twist::kS,
          .turns_per_m = 240,
          .plies = 2,
          .fibre_um = 28,
          .groove_depth = 0.25f,
          .hairiness = 0.06f,
          .flattening = 0.65f,
          .unevenness = 10,
          .lobes =
              {
                  .specular = 0.95f,
                  .ior = 1.56f,
                  .along_width = 0.087f,
                  .across_width = 0.89f,
                  .layers = 4.5f,
                  .inner = 0.09f,
                  .body = 0.9f,
                  .fuzz = 0.012f,
                  .fuzz_width = 0.40f,
                  .transmission = 0.14f,
              },
          .tex = 66.7f,
      },
      // Nm 28/2 worsted, 71 tex, phi 0.5; 18 degrees.
      {
          .name = mark("Wool"),
          .fibre = Fibre::kWool,
          .section = CrossSection::kRound,
          .diameter_mm = 0.37f,
          .twist = Twist::kS,
          .turns_per_m = 280,
          .plies = 2,
          .fibre_um = 70,
          .groove_depth = 0.40f,
          .hairiness = 0.65f,
          .flattening = 0.75f,
          .unevenness = 13,
          .lobes =
              {
                  .specular = 0.7f,
                  .ior = 1.55f,
                  .along_width = 0.42f,
                  .across_width = 0.60f,
                  .layers = 2,
                  .inner = 0.10f,
                  .body = 1.0f,
                  .fuzz = 0.35f,
                  .fuzz_width = 0.65f,
                  .transmission = 0.10f,
              },
          .tex = 71.4f,
      },
      // 300 den filament, 33 tex, phi 0.6; 5 degrees.
      {
          .name = mark("Viscose"),
          .fibre = Fibre::kViscose,
          .section = CrossSection::kRound,
          .diameter_mm = 0.22f,
          .twist = Twist::kZ,
          .turns_per_m = 127,
          .plies = 1,
          .fibre_um = 26,
          .groove_depth = 0.18f,
          .hairiness = 0.04f,
          .flattening = 0.60f,
          .unevenness = 1,
          .lobes =
              {
                  .specular = 1.0f,
                  .ior = 1.53f,
                  .along_width = 0.10f,
                  .across_width = 0.60f,
                  .layers = 4,
                  .inner = 0.10f,
                  .body = 0.9f,
                  .fuzz = 0.02f,
                  .fuzz_width = 0.40f,
                  .transmission = 0.20f,
              },
          .tex = 33.3f,
      },
      // 150 den filament, 17 tex, phi 0.6; 4 degrees.
      {
          .name = mark("Polyester filament"),
          .fibre = Fibre::kPolyester,
          .section = CrossSection::kRound,
          .diameter_mm = 0.16f,
          .twist = Twist::kZ,
          .turns_per_m = 139,
          .plies = 1,
          .fibre_um = 24,
          .groove_depth = 0.12f,
          .hairiness = 0.02f,
          .flattening = 0.60f,
          .unevenness = 1,
          .lobes =
              {
                  .specular = 0.95f,
                  .ior = 1.63f,
                  .along_width = 0.06f,
                  .across_width = 0.69f,
                  .layers = 8,
                  .inner = 0.02f,
                  .body = 0.9f,
                  .fuzz = 0.004f,
                  .fuzz_width = 0.35f,
                  .transmission = 0.12f,
              },
          .tex = 16.7f,
      },
      // Slit film 0.37 mm wide, 12 um thick: 6.2 tex; with two 30 den of core 12.9 tex. Folded to about 0.25 mm.
      {
          .name = mark("Metallic"),
          .fibre = Fibre::kMetallic,
          .section = CrossSection::kFlat,
          .diameter_mm = 0.25f,
          .twist = Twist::kNone,
          .turns_per_m = 0,
          .plies = 1,
          .fibre_um = 370,
          .groove_depth = 0.05f,
          .hairiness = 0.0f,
          .flattening = 0.45f,
          .unevenness = 0,
          .lobes =
              {
                  .specular = 1.0f,
                  .ior = 1.50f,
                  .along_width = 0.06f,
                  .across_width = 0.22f,
                  .layers = 1,
                  .inner = 0,
                  .body = 0.0f,
                  .fuzz = 0.0f,
                  .fuzz_width = 0.30f,
                  .transmission = 0.0f,
                  .metallic = true,
              },
          .tex = 12.9f,
      },
  }};
}

}  // namespace

std::span<const Yarn> yarn_presets() {
  static const std::array<Yarn, kFibres> presets = make_presets();
  return presets;
}

const Yarn& ready_yarn(Fibre fibre) { return yarn_presets()[static_cast<size_t>(fibre)]; }

}  // namespace weftlight::design
