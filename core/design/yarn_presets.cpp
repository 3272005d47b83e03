// Where the numbers come from.
//
// Diameter: of a round thread of the count named below, d = 2 sqrt(tex / (1000 pi rho phi)) mm, with the
//   density rho of the fibre and the packing phi, the fraction of the thread that is fibre. rho, g/cm3: cotton 1.52,
//   flax 1.50, silk 1.34, wool 1.31, viscose 1.52, polyester 1.39 (W. E. Morton and J. W. S. Hearle, Physical
//   Properties of Textile Fibres, ch. 5). phi in the washed cloth: cotton, wool and spun polyester 0.4 to 0.5, where
//   spun yarn has 0.5 to 0.6 (fibre.cpp), linen 0.55 of 0.65, gassed and filament 0.6 and more, as spun; by the cover
//   of the shipped cloths (presets/cloths), whose yarns have 0.37 (combed cotton) to 0.6, and so that washed plain
//   weave of cotton at a firm sett has pinholes and no net of gaps; by eye.
// Turns: of the last twist, from the angle alpha that the fibres lie at on the surface,
//   T = 1000 tan(alpha) / (pi d) with d as spun. Spun cotton and polyester 20-25 degrees (combed 20: longer fibres hold
//   with less), worsted about 18, woollen 16, linen about 16, spun silk about 14, filament with a producer's twist
//   under 5 (J. W. S. Hearle, P. Grosberg, S. Backer, Structural Mechanics of Fibers, Yarns, and Fabrics, 1969, on
//   twist factors). Tram, the reeled silk for weft, is thrown with 80 to 180 turns a metre.
// Plies: two for what weavers buy as a plied warp, one for the rest.
// Grooves: width of the fibre bundles between them, some fibres wide. Fibres: cotton 12-20, flax
//   ultimates 15-20 in technical fibres of 50-100, silk 10-13, wool 20-25, filaments 12-18 um (Morton and Hearle,
//   ch. 3). Deep where bundles stay separate (linen), shallow in smooth filament.
// Hairiness: rank of the Uster hairiness of such yarns, woollen over worsted over carded cotton over spun polyester
//   over combed cotton over gassed cotton; filament has almost no free fibre ends. Spun silk is gassed.
// Flattening: after weaving, washing and pressing, where threads touch; by the shipped cloths. Peirce 1937 found 0.6
//   to 0.8 in grey cotton; low twist spreads more.
// Unevenness: medians of such yarns in the Uster Statistics, that of the singles over the square root of the plies;
//   filament 1, reeled silk 4 (the cocoon's thread tapers, and is joined).
// Index of refraction: mean of the two of the fibre: cotton 1.578/1.532, flax 1.596/1.528, silk 1.591/1.538, wool
//   1.556/1.547, viscose 1.539/1.519, polyester 1.725/1.537 (Morton and Hearle, ch. 24).
// Lobes of silk, wool, viscose and polyester: from their fibres (docs/decisions/lobes-follow-from-fibres.md), by
//   `weftlight lobes --fit-lustre` on presets/yarns, which took silk from 0.54 octaves off its own fibres to 0.34, wool
//   0.87 to 0.45, viscose 0.50 to 0.33, polyester filament 0.43 to 0.34, spun 0.45 to 0.35. They lie near the tangents
//   of the widths that I. Sadeghi, O. Bisker, J. De Deken, H. W. Jensen, A Practical Microcylinder Appearance Model for
//   Cloth Rendering, 2013, give for threads: silk 5 degrees (surface) and 10 (volume), polyester satin 2.5 and 5.
//   Layers of polyester filament were 15.3: 12 leave room for flat sides. Reeled silk is smoother than spun; its
//   numbers are of a fit in which both were 0.076 and 0.087 wide.
// Lobes of cotton and linen: widths, layers, inner part and fuzz were fitted to measured cloths (tests/measured,
//   docs/measured.md): cotton to denim and twill, linen to a plain weave. Combed cotton has the lobes of carded: it
//   differs by its hair. Mercerised cotton: by rank, for mercerising swells cotton round and smooth.
// Lobes of woollen: by rank, duller than worsted. Its fibres lie across each other, by some 15 degrees, which traced
//   fibres do not: theirs are as parallel as in worsted.
// Fuzz of combed cotton, reeled silk, woollen and spun polyester: that of the usual yarn, in the ratio of their
//   hairiness.
// Transmission: by eye, in the order of the fibres' lustre; delustred fibre scatters most inside. As a fraction of the
//   diffuse part it rose where that fell, so that as much light passes.
// Metallic: aluminium under a clear lacquer on a slit film of about 1/69 inch (the common count), wound or
//   laid flat: a ribbon, specular along its length, no body. The index is that of the lacquer.

#include "design/yarn_presets.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <vector>

#include "base/mark.h"

namespace weftlight::design {

using base::mark;

namespace {

// Fields that are absent have the default of yarn.h.

/// The usual ones. Files, their recognition and the measured cloths go by their numbers.
std::array<Yarn, kFibres> make_presets() {
  return {{
      // Ne 8/2 ring-spun, 148 tex, phi 0.46; 22 degrees.
      {
          .name = mark("Cotton"),
          .diameter_mm = 0.52f,
          .twist = Twist::kS,
          .turns_per_m = 285,
          .plies = 2,
          .fibre_um = 60,
          .groove_depth = 0.45f,
          .hairiness = 0.35f,
          .flattening = 0.50f,
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
          .flattening = 0.54f,
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
          .flattening = 0.60f,
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
          .flattening = 0.55f,
          .unevenness = 10,
          .lobes =
              {
                  .specular = 0.95f,
                  .ior = 1.56f,
                  .along_width = 0.085f,
                  .across_width = 0.56f,
                  .layers = 6.3f,
                  .inner = 0.40f,
                  .body = 0.58f,
                  .fuzz = 0.012f,
                  .fuzz_width = 0.40f,
                  .transmission = 0.22f,
              },
          .tex = 66.7f,
      },
      // Nm 28/2 worsted, 71 tex, phi 0.43; 18 degrees.
      {
          .name = mark("Wool"),
          .fibre = Fibre::kWool,
          .section = CrossSection::kRound,
          .diameter_mm = 0.40f,
          .twist = Twist::kS,
          .turns_per_m = 280,
          .plies = 2,
          .fibre_um = 70,
          .groove_depth = 0.40f,
          .hairiness = 0.65f,
          .flattening = 0.60f,
          .unevenness = 13,
          .lobes =
              {
                  .specular = 0.7f,
                  .ior = 1.55f,
                  .along_width = 0.121f,
                  .across_width = 0.214f,
                  .layers = 4.7f,
                  .inner = 0.837f,
                  .body = 0.75f,
                  .fuzz = 0.35f,
                  .fuzz_width = 0.65f,
                  .transmission = 0.13f,
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
          .flattening = 0.50f,
          .unevenness = 1,
          .lobes =
              {
                  .specular = 1.0f,
                  .ior = 1.53f,
                  .along_width = 0.133f,
                  .across_width = 0.436f,
                  .layers = 6.4f,
                  .inner = 0.45f,
                  .body = 0.51f,
                  .fuzz = 0.02f,
                  .fuzz_width = 0.40f,
                  .transmission = 0.35f,
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
          .flattening = 0.50f,
          .unevenness = 1,
          .lobes =
              {
                  .specular = 0.95f,
                  .ior = 1.63f,
                  .along_width = 0.061f,
                  .across_width = 0.40f,
                  .layers = 12,
                  .inner = 0.40f,
                  .body = 0.49f,
                  .fuzz = 0.004f,
                  .fuzz_width = 0.35f,
                  .transmission = 0.22f,
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

/// Others of the same fibres.
std::array<Yarn, 4> make_other_yarns() {
  Lobes combed = ready_yarn(Fibre::kCotton).lobes;  // its fibres are those of carded
  combed.fuzz = 0.085f;
  return {{
      // Ne 20/2 combed, ring-spun, 59 tex, phi 0.45; 20 degrees.
      {
          .name = mark("Combed cotton"),
          .diameter_mm = 0.33f,
          .twist = Twist::kS,
          .turns_per_m = 400,
          .plies = 2,
          .fibre_um = 36,
          .groove_depth = 0.40f,
          .hairiness = 0.25f,
          .flattening = 0.50f,
          .unevenness = 8.5f,
          .lobes = combed,
          .tex = 59.05f,
      },
      // Tram of twelve threads of raw silk of 20/22 den, without its gum (24 %) Nm 47, 21 tex, phi 0.6; 3 degrees.
      {
          .name = mark("Reeled silk"),
          .fibre = Fibre::kSilk,
          .section = CrossSection::kTrilobal,
          .diameter_mm = 0.18f,
          .twist = Twist::kS,
          .turns_per_m = 100,
          .plies = 1,
          .fibre_um = 22,
          .groove_depth = 0.15f,
          .hairiness = 0.02f,
          .flattening = 0.50f,
          .unevenness = 4,
          .lobes =
              {
                  .specular = 0.95f,
                  .ior = 1.56f,
                  .along_width = 0.076f,
                  .across_width = 0.43f,
                  .layers = 6.3f,
                  .inner = 0.42f,
                  .body = 0.58f,
                  .fuzz = 0.004f,
                  .fuzz_width = 0.40f,
                  .transmission = 0.22f,
              },
          .tex = 21.28f,
      },
      // Nm 8/2 woollen, 250 tex, phi 0.4; 16 degrees.
      {
          .name = mark("Woollen yarn"),
          .fibre = Fibre::kWool,
          .section = CrossSection::kRound,
          .diameter_mm = 0.78f,
          .twist = Twist::kS,
          .turns_per_m = 117,
          .plies = 2,
          .fibre_um = 60,
          .groove_depth = 0.25f,
          .hairiness = 0.90f,
          .flattening = 0.60f,
          .unevenness = 14,
          .lobes =
              {
                  .specular = 0.7f,
                  .ior = 1.55f,
                  .along_width = 0.25f,
                  .across_width = 0.30f,
                  .layers = 3,
                  .inner = 0.6f,
                  .body = 0.85f,
                  .fuzz = 0.48f,
                  .fuzz_width = 0.75f,
                  .transmission = 0.12f,
              },
          .tex = 250,
      },
      // Ne 30/2 ring-spun of cut fibre, 39 tex, phi 0.46; 20 degrees.
      {
          .name = mark("Spun polyester"),
          .fibre = Fibre::kPolyester,
          .section = CrossSection::kRound,
          .diameter_mm = 0.28f,
          .twist = Twist::kS,
          .turns_per_m = 463,
          .plies = 2,
          .fibre_um = 32,
          .groove_depth = 0.40f,
          .hairiness = 0.28f,
          .flattening = 0.55f,
          .unevenness = 9,
          .lobes =
              {
                  .specular = 0.95f,
                  .ior = 1.63f,
                  .along_width = 0.107f,
                  .across_width = 0.43f,
                  .layers = 7.7f,
                  .inner = 0.38f,
                  .body = 0.62f,
                  .fuzz = 0.056f,
                  .fuzz_width = 0.50f,
                  .transmission = 0.17f,
              },
          .tex = 39.37f,
      },
  }};
}

std::vector<Yarn> grouped_by_fibre() {
  std::vector<Yarn> all;
  const std::array<Yarn, 4> others = make_other_yarns();
  for (const Yarn& usual : yarn_presets()) {
    all.push_back(usual);
    std::copy_if(others.begin(), others.end(), std::back_inserter(all),
                 [&](const Yarn& y) { return y.fibre == usual.fibre; });
  }
  return all;
}

}  // namespace

std::span<const Yarn> yarn_presets() {
  static const std::array<Yarn, kFibres> presets = make_presets();
  return presets;
}

const Yarn& ready_yarn(Fibre fibre) { return yarn_presets()[static_cast<size_t>(fibre)]; }

std::span<const Yarn> ready_yarns() {
  static const std::vector<Yarn> all = grouped_by_fibre();
  return all;
}

}  // namespace weftlight::design
