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

constexpr Rgb kWhite{1, 1, 1};

std::array<Yarn, 8> make_presets() {
  // The last number is the count, tex. Lobes: specular, tint, index, along, across, layers, inner, body, fuzz, fuzz
  // width, transmission, metallic.
  return {{
      // Ne 8/2 ring-spun, 148 tex, phi 0.6; 22 degrees.
      {mark("Cotton"),
       0.45f,
       Twist::kS,
       285,
       2,
       60,
       0.45f,
       0.35f,
       0.70f,
       0,
       11,
       0,
       {1.0f, kWhite, 1.55f, 0.30f, 0.20f, 3, 0.10f, 0.9f, 0.12f, 0.55f, 0.12f, false},
       147.6f},
      // Ne 10/2 gassed, 118 tex, phi 0.65; 20 degrees.
      {mark("Mercerised cotton"),
       0.39f,
       Twist::kS,
       297,
       2,
       40,
       0.35f,
       0.10f,
       0.75f,
       0,
       9,
       0,
       {1.0f, kWhite, 1.55f, 0.16f, 0.30f, 4, 0.12f, 0.9f, 0.06f, 0.45f, 0.12f, false},
       118.1f},
      // Lea 16/2 wet-spun, 207 tex, phi 0.65; 16 degrees.
      {mark("Linen"),
       0.52f,
       Twist::kS,
       176,
       2,
       90,
       0.55f,
       0.22f,
       0.75f,
       0,
       18,
       0,
       {1.0f, kWhite, 1.56f, 0.38f, 0.30f, 4.4f, 0.40f, 0.9f, 0.02f, 0.50f, 0.14f, false},
       206.7f},
      // Nm 30/2 spun, 67 tex, phi 0.6; 14 degrees.
      {mark("Silk"),
       0.33f,
       Twist::kS,
       240,
       2,
       28,
       0.25f,
       0.06f,
       0.65f,
       0,
       10,
       0,
       {0.95f, kWhite, 1.56f, 0.087f, 0.89f, 4.5f, 0.09f, 0.9f, 0.012f, 0.40f, 0.14f, false},
       66.7f},
      // Nm 28/2 worsted, 71 tex, phi 0.5; 18 degrees.
      {mark("Wool"),
       0.37f,
       Twist::kS,
       280,
       2,
       70,
       0.40f,
       0.65f,
       0.75f,
       0,
       13,
       0,
       {0.7f, kWhite, 1.55f, 0.42f, 0.60f, 2, 0.10f, 1.0f, 0.35f, 0.65f, 0.10f, false},
       71.4f},
      // 300 den filament, 33 tex, phi 0.6; 5 degrees.
      {mark("Viscose"),
       0.22f,
       Twist::kZ,
       127,
       1,
       26,
       0.18f,
       0.04f,
       0.60f,
       0,
       1,
       0,
       {1.0f, kWhite, 1.53f, 0.10f, 0.60f, 4, 0.10f, 0.9f, 0.02f, 0.40f, 0.20f, false},
       33.3f},
      // 150 den filament, 17 tex, phi 0.6; 4 degrees.
      {mark("Polyester filament"),
       0.16f,
       Twist::kZ,
       139,
       1,
       24,
       0.12f,
       0.02f,
       0.60f,
       0,
       1,
       0,
       {0.95f, kWhite, 1.63f, 0.06f, 0.69f, 8, 0.02f, 0.9f, 0.004f, 0.35f, 0.12f, false},
       16.7f},
      // Slit film 0.37 mm wide, 12 um thick: 6.2 tex; with two 30 den of core 12.9 tex. Folded to about 0.25 mm.
      {mark("Metallic"),
       0.25f,
       Twist::kNone,
       0,
       1,
       370,
       0.05f,
       0.0f,
       0.45f,
       0,
       0,
       0,
       {1.0f, kWhite, 1.50f, 0.06f, 0.22f, 1, 0, 0.0f, 0.0f, 0.30f, 0.0f, true},
       12.9f},
  }};
}

}  // namespace

std::span<const Yarn> yarn_presets() {
  static const std::array<Yarn, 8> presets = make_presets();
  return presets;
}

}  // namespace weftlight::design
