// Whole cloths: weave, sett of the finished cloth, yarns by count. Their output is presets/cloths.
//
// Setts are customary constructions (J. J. Pizzuto, Fabric Science; S. Adanur, Handbook of Weaving, 2001), and counts
// are the usual ones at these setts: denim 14 oz of Ne 6 by Ne 5; chambray and chintz of Ne 40, 112 by 90 an
// inch; oxford, two ends of Ne 40 by Ne 14, 2 x 53 by 63; gabardine of Nm 60/2, 2 : 1; tweed of woollen Nm 5.6
// (Harris); flannel of woollen Nm 15; linen of lea 25, table damask on five shafts of lea 40. Silks are raw silk of
// 20/22 denier, several threads together, as usual for cloth of 14 to 36 momme; boiled off they lose 24 %
// (sericin is 22 to 25 % of raw silk: J. G. Cook, Handbook of Textile Fibres, 1984). The thickness of the threads in
// the finished cloth is by eye; docs/measured.md holds the weights.

#include <cmath>

#include "../yarns.h"
#include "design/count.h"
#include "recipes.h"
#include "weaves/weaves.h"

namespace weftlight::wif {

using design::Design, design::Twist, design::Yarn, design::tex_from_text;
using draft::Face, draft::Rgb;
using weaves::Lean, weaves::Recipe, weaves::herringbone, weaves::make_design, weaves::plain, weaves::satin,
    weaves::twill, weaves::with_colors;

namespace {

constexpr float kReeled = 4;         // reeled silk; the preset is spun silk
constexpr float kBoiledOff = 0.76f;  // weight after degumming over that of raw silk

/// The preset spun to a count, with the given thickness in the finished cloth (washing and milling open yarns, contact
/// between threads closes them); `turns` per metre, of the singles.
Yarn spun(const char* preset, const char* name, const char* count, float diameter_mm, float turns, int plies = 1) {
  Yarn yarn = as_spun(preset);
  yarn.name = std::string(name) + " " + count;
  yarn.diameter_mm = diameter_mm;
  yarn.tex = static_cast<float>(std::round(100 * tex_from_text(count).value_or(30)) / 100);
  yarn.turns_per_m = turns, yarn.plies = plies;
  if (preset == std::string("Silk")) yarn.unevenness = kReeled;
  return yarn;
}

Yarn boiled_off(Yarn yarn) {
  yarn.tex = std::round(100 * kBoiledOff * yarn.tex) / 100;
  return yarn;
}

/// Sett of the finished cloth, threads per centimetre.
Design set_at(Design design, float ends_per_cm, float picks_per_cm) {
  design.draft.warp.spacing_mm.assign(design.draft.warp.color.size(), 10 / ends_per_cm);
  design.draft.weft.spacing_mm.assign(design.draft.weft.color.size(), 10 / picks_per_cm);
  return design;
}

/// Shown on that mesh.
Design worn(Design design, const char* mesh, float azimuth, float elevation, float distance = 1) {
  design.scene.mesh = mesh;
  design.scene.view_azimuth = azimuth, design.scene.view_elevation = elevation;
  design.scene.view_distance = distance;
  return design;
}

/// Direction of the key light.
Design lit(Design design, float azimuth, float elevation) {
  design.scene.light_azimuth = azimuth, design.scene.light_elevation = elevation;
  return design;
}

// The measured cloths (tests/measured). Sett, thickness and dye vary within the usual range of such cloths and were
// fitted together with the lobes. The lobes of the ready cotton and linen are these; silk and polyester have their own
// here, since the ready ones follow from their fibres.

/// Linear reflectance as a palette colour.
Rgb dye(float r, float g, float b) {
  const auto channel = [](float v) { return v <= 0.0031308f ? 12.92f * v : 1.055f * std::pow(v, 1 / 2.4f) - 0.055f; };
  // In steps of 1/255, as in plain WIF.
  const auto whole = [&](float v) { return std::round(255 * channel(v)) / 255; };
  return {whole(r), whole(g), whole(b)};
}

Yarn fitted(const char* preset, const char* name, const char* count, float diameter_mm, float flattening, float turns) {
  Yarn yarn = spun(preset, name, count, diameter_mm, turns);
  yarn.flattening = flattening;
  yarn.twist = Twist::kZ;
  yarn.unevenness = 0;  // as in the fit
  return yarn;
}

/// In two colours, with the given spacings (mm).
Design measured(Design d, Rgb warp_dye, Rgb weft_dye, const Yarn& warp, const Yarn& weft, float ends_mm,
                float picks_mm) {
  d = with_colors(std::move(d), {warp_dye, weft_dye}, {{0, 1}}, {{1, 1}});
  d = with_yarns(std::move(d), warp, weft);
  d.draft.warp.spacing_mm.assign(d.draft.warp.color.size(), ends_mm);
  d.draft.weft.spacing_mm.assign(d.draft.weft.color.size(), picks_mm);
  return d;
}

Design linen_plain() {
  const Rgb blue = dye(0.103f, 0.28f, 0.36f);
  const Yarn yarn = fitted("Linen", "Linen", "40 lea", 0.254f, 0.5f, 320);
  return titled(worn(measured(plain({16, 16}), blue, blue, yarn, yarn, 0.36f, 0.36f), "tablecloth", 25, 24),
                "Linen, measured", {"Plain weave, 28 by 28 a centimetre, as Sadeghi and others 2013 measured it."});
}

Yarn charmeuse_silk(const char* count, float diameter_mm, float flattening, float turns) {
  Yarn yarn = boiled_off(fitted("Silk", "Silk", count, diameter_mm, flattening, turns));
  yarn.lobes.along_width = 0.087f, yarn.lobes.across_width = 0.89f, yarn.lobes.layers = 4.5f;
  yarn.lobes.inner = 0.09f, yarn.lobes.body = 0.9f, yarn.lobes.transmission = 0.14f;
  return yarn;
}

Design crepe_de_chine() {
  const Rgb gold = dye(0.23f, 0.243f, 0.0039f);
  Yarn warp = boiled_off(fitted("Silk", "Raw silk", "66 den", 0.092f, 0.35f, 67));
  warp.lobes.along_width = 0.077f, warp.lobes.across_width = 0.08f, warp.lobes.layers = 8.2f, warp.lobes.inner = 0.51f;
  warp.lobes.body = 0.9f, warp.lobes.transmission = 0.14f;
  Yarn weft = boiled_off(fitted("Silk", "Crepe silk", "66 den", 0.09f, 0.99f, 1075));
  weft.lobes.along_width = 0.23f, weft.lobes.across_width = 0.3f, weft.lobes.layers = 5, weft.lobes.inner = 0.25f;
  weft.lobes.body = 0.9f, weft.lobes.transmission = 0.14f;
  return titled(worn(measured(plain({16, 16}), gold, gold, warp, weft, 0.13f, 0.28f), "skirt", 15, 12),
                "Silk crepe de chine, measured",
                {"Plain weave, flat warp over hard-twisted weft, 77 by 36 a centimetre (Sadeghi and others 2013)."});
}

Design polyester_charmeuse() {
  Recipe crowfoot;  // four-shaft satin, warp-faced
  crowfoot.shafts = 4, crowfoot.threading = {0, 1, 2, 3}, crowfoot.treadling = {0, 1, 3, 2};
  crowfoot.tieup = {{1, 2, 3}, {0, 2, 3}, {0, 1, 3}, {0, 1, 2}};
  const Rgb rose = dye(0.247f, 0.0646f, 0.0646f);
  Yarn warp = fitted("Polyester filament", "Polyester", "75 den", 0.12f, 0.6f, 29);
  warp.groove_depth = 0.092f;
  warp.lobes.specular = 0.656f, warp.lobes.along_width = 0.144f, warp.lobes.across_width = 0.7f,
  warp.lobes.layers = 13.9f, warp.lobes.inner = 0.097f, warp.lobes.body = 0.331f, warp.lobes.fuzz = 0.001f;
  warp.lobes.transmission = 0.12f;
  Yarn weft = fitted("Polyester filament", "Polyester", "100 den", 0.13f, 0.711f, 10);
  weft.groove_depth = 0.049f;
  weft.lobes.specular = 1, weft.lobes.along_width = 0.103f, weft.lobes.across_width = 0.0585f, weft.lobes.layers = 16,
  weft.lobes.inner = 0.0148f, weft.lobes.body = 1, weft.lobes.transmission = 0.12f;
  // So close a sett that it is opaque, as charmeuse is.
  return titled(
      worn(measured(make_design(crowfoot, {16, 16}), rose, rose, warp, weft, 0.161f, 0.388f), "skirt", 15, 12),
      "Polyester satin charmeuse, measured",
      {"Warp satin on four shafts, 62 by 26 a centimetre (Sadeghi and others 2013)."});
}

Design cotton_denim() {
  const Yarn warp = fitted("Cotton", "Cotton", "Ne 7.8", 0.325f, 0.55f, 400),
             weft = fitted("Cotton", "Cotton", "Ne 5.2", 0.4f, 0.86f, 461);
  return titled(worn(measured(twill({3, 1}, Lean::kRight, {32, 32}), dye(0.0164f, 0.0213f, 0.0235f),
                              dye(0.11f, 0.11f, 0.11f), warp, weft, 0.41f, 0.52f),
                     "skirt", 20, 12),
                "Cotton denim, measured", {"3/1 twill, 24 by 19 a centimetre (Irawan and Marschner 2012)."});
}

Design silk_charmeuse() {
  const Rgb plum = dye(0.012f, 0.012f, 0.012f);
  const Yarn warp = charmeuse_silk("66 den", 0.1f, 0.95f, 60), weft = charmeuse_silk("40 den", 0.081f, 0.83f, 33);
  return titled(
      worn(measured(satin(8, 3, Face::kFront, {16, 16}), plum, plum, warp, weft, 0.0993f, 0.165f), "skirt", 15, 12),
      "Silk charmeuse, measured", {"Warp satin on eight shafts, 101 by 61 a centimetre (Irawan and Marschner 2012)."});
}

Design cotton_twill() {
  const Rgb dark = dye(0.012f, 0.012f, 0.012f);
  const Yarn warp = fitted("Cotton", "Cotton", "Ne 19", 0.208f, 0.55f, 1100),
             weft = fitted("Cotton", "Cotton", "Ne 12.5", 0.257f, 0.55f, 1100);
  return titled(
      worn(measured(twill({3, 1}, Lean::kRight, {32, 32}), dark, dark, warp, weft, 0.257f, 0.35f), "skirt", -25, 10),
      "Cotton twill, measured", {"3/1 twill, 39 by 29 a centimetre (Irawan and Marschner 2012)."});
}

Design denim() {
  Design d = with_colors(twill({3, 1}, Lean::kRight, {128, 128}), palette({0x25386a, 0xf2ecde}), {{0, 1}}, {{1, 1}});
  Yarn warp = spun("Cotton", "Ring-spun cotton", "Ne 6", 0.376f, 560),
       weft = spun("Cotton", "Cotton", "Ne 5", 0.406f, 480);
  warp.twist = weft.twist = Twist::kZ;
  // Indigo stays on the outside of rope-dyed ends and wears off where they protrude: variation along and between ends.
  warp.irregularity = 0.07f, warp.melange = 0.4f, warp.fibre_um = 35;
  weft.irregularity = 0.05f;
  // Ring-spun with intended slubs, as denim is.
  warp.unevenness = 26, weft.unevenness = 20;
  d = set_at(with_yarns(std::move(d), warp, weft), 26, 17);
  return titled(worn(std::move(d), "shirt", 20, 10, 0.88f), "Denim",
                {"3/1 right-hand twill, 14 oz: indigo Ne 6 over ecru Ne 5, 26 by 17 a centimetre."});
}

Design chambray() {
  Design d = with_colors(plain({128, 128}), palette({0x3463a8, 0xf6f5f1}), {{0, 1}}, {{1, 1}});
  Yarn yarn = spun("Cotton", "Combed cotton", "Ne 40", 0.182f, 820);
  yarn.flattening = 0.55f, yarn.irregularity = 0.06f, yarn.unevenness = 15, yarn.fibre_um = 22;
  yarn.hairiness = 0.35f, yarn.melange = 0.15f;
  d = set_at(with_yarns(std::move(d), yarn, yarn), 44, 36);
  return titled(worn(std::move(d), "shirt", 20, 8, 0.88f), "Chambray",
                {"Plain weave, blue warp and white weft, Ne 40, 44 by 36 a centimetre."});
}

Design oxford() {
  Recipe pairs;
  pairs.shafts = 2, pairs.threading = {0, 0, 1, 1}, pairs.tieup = {{0}, {1}}, pairs.treadling = {0, 1};
  Design d = with_colors(make_design(pairs, {128, 80}), palette({0x8fb2dc, 0xf6f5f1}), {{0, 1}}, {{1, 1}});
  Yarn warp = spun("Cotton", "Combed cotton", "Ne 40", 0.176f, 850),
       weft = spun("Cotton", "Soft cotton", "Ne 14", 0.315f, 380);
  warp.irregularity = 0.04f, warp.unevenness = 13, warp.fibre_um = 22, warp.hairiness = 0.3f, warp.melange = 0.1f;
  weft.irregularity = 0.05f, weft.unevenness = 15, weft.fibre_um = 30, weft.flattening = 0.7f;
  d = set_at(with_yarns(std::move(d), warp, weft), 42, 25);
  return titled(worn(std::move(d), "shirt", -20, 8, 0.88f), "Oxford",
                {"Two fine blue ends weave as one over a soft white weft three times as heavy.",
                 "Ne 40 by Ne 14, 42 by 25 a centimetre."});
}

Design gabardine() {
  Design d = with_colors(twill({2, 2}, Lean::kRight, {32, 32}), palette({0xa5916c, 0x9b8763}), {{0, 1}}, {{1, 1}});
  Yarn yarn = spun("Wool", "Worsted", "Nm 60/2", 0.26f, 620, 2);
  yarn.twist = Twist::kS, yarn.irregularity = 0.02f, yarn.fibre_um = 24, yarn.hairiness = 0.12f,
  yarn.groove_depth = 0.3f;
  // Clear finish: singed, cropped and pressed.
  yarn.lobes.fuzz = 0.08f;
  d = set_at(with_yarns(std::move(d), yarn, yarn), 44, 24);
  return titled(worn(std::move(d), "skirt", -25, 10, 1), "Gabardine",
                {"2/2 twill that stands at 63 degrees, for the ends lie twice as close as the picks.",
                 "Worsted Nm 60/2, 44 by 24 a centimetre, clear finish."});
}

Design tweed() {
  Design d = with_colors(herringbone({2, 2}, 16, {128, 128}), palette({0x54432f, 0xc9b999}), {{0, 1}}, {{1, 1}});
  Yarn yarn = spun("Woollen yarn", "Woollen", "Nm 5.6", 0.932f, 260);
  yarn.twist = Twist::kZ, yarn.irregularity = 0.06f, yarn.unevenness = 26, yarn.melange = 1.0f, yarn.fibre_um = 45,
  yarn.hairiness = 1.0f;
  yarn.groove_depth = 0.25f, yarn.flattening = 0.7f, yarn.lobes.fuzz = 0.6f, yarn.lobes.fuzz_width = 0.8f;
  d = set_at(with_yarns(std::move(d), yarn, yarn), 9.6f, 9);
  return titled(
      worn(std::move(d), "tunic", -20, 8, 0.88f), "Herringbone tweed",
      {"2/2 twill that turns every sixteen ends; woollen Nm 5.6 in heather mixtures, 9.6 by 9 a centimetre."});
}

Design flannel() {
  Design d = with_colors(twill({2, 2}, Lean::kRight, {128, 128}), palette({0x9b9ea4, 0x9b9ea4}), {{0, 1}}, {{1, 1}});
  Yarn yarn = spun("Woollen yarn", "Woollen", "Nm 15", 0.366f, 250);
  yarn.twist = Twist::kZ, yarn.irregularity = 0.04f, yarn.unevenness = 20, yarn.melange = 0.8f;
  d.finish.raised = 1;  // napped
  d = set_at(with_yarns(std::move(d), yarn, yarn), 19, 17);
  return titled(worn(std::move(d), "tunic", 25, 10, 0.88f), "Flannel",
                {"2/2 twill of grey melange, woollen Nm 15, 19 by 17 a centimetre, milled and raised."});
}

Design chintz() {
  Design d = with_colors(plain({16, 16}), palette({0x1f6a5c, 0x1f6a5c}), {{0, 1}}, {{1, 1}});
  Yarn yarn = spun("Cotton", "Cotton", "Ne 40", 0.182f, 900);
  yarn.twist = Twist::kZ, yarn.irregularity = 0.04f;
  d.finish.calendered = 1;
  d = set_at(with_yarns(std::move(d), yarn, yarn), 42, 36);
  return titled(worn(std::move(d), "curtain", 20, 8), "Chintz",
                {"Plain weave of cotton Ne 40, 42 by 36 a centimetre, calendered: flat threads, a glazed face."});
}

Design silk_satin() {
  Design d = with_colors(satin(8, 3, Face::kFront, {16, 16}), palette({0xc9a05c, 0xb98f4e}), {{0, 1}}, {{1, 1}});
  Yarn warp = boiled_off(spun("Silk", "Organzine", "63 den", 0.113f, 120)),
       weft = boiled_off(spun("Silk", "Tram", "252 den", 0.226f, 100));
  d = set_at(with_yarns(std::move(d), warp, weft), 118, 42);
  return titled(lit(worn(std::move(d), "skirt", 15, 12), -35, 18), "Silk satin",
                {"Duchesse: warp satin on eight shafts, 118 by 42 a centimetre, raw silk 3 and 12 fold."});
}

Design taffeta() {
  Design d = with_colors(plain({16, 16}), palette({0x123a9e, 0xb5122e}), {{0, 1}}, {{1, 1}});
  Yarn warp = boiled_off(spun("Silk", "Organzine", "84 den", 0.131f, 500)),
       weft = boiled_off(spun("Silk", "Tram", "126 den", 0.16f, 120));
  warp.flattening = weft.flattening = 0.5f;
  d = set_at(with_yarns(std::move(d), warp, weft), 62, 46);
  return titled(lit(worn(std::move(d), "skirt", 15, 12), -40, 25), "Shot taffeta",
                {"Blue warp and red weft in plain weave, 62 by 46 a centimetre: the colour turns with the light."});
}

Design organza() {
  Design d = with_colors(plain({16, 16}), palette({0xf2b8c6, 0xf6c8d2}), {{0, 1}}, {{1, 1}});
  Yarn yarn = spun("Silk", "Gum silk", "21 den", 0.061f, 1200);
  yarn.flattening = 1, yarn.lobes.transmission = 0.35f;
  d = set_at(with_yarns(std::move(d), yarn, yarn), 44, 40);
  return titled(
      worn(std::move(d), "skirt", 20, 10), "Organza",
      {"Plain weave of hard-twisted raw silk in the gum, 21 denier, 44 by 40 a centimetre: sheer and crisp."});
}

Design linen() {
  Design d = with_colors(plain({128, 128}), palette({0xcdbf9f, 0xd6c9ab}), {{0, 1}}, {{1, 1}});
  Yarn yarn = spun("Linen", "Wet-spun linen", "25 lea", 0.355f, 330);
  yarn.irregularity = 0.14f, yarn.unevenness = 36, yarn.melange = 0.35f, yarn.twist = Twist::kZ, yarn.fibre_um = 50;
  yarn.flattening = 0.55f;
  d = set_at(with_yarns(std::move(d), yarn, yarn), 21, 20);
  return titled(worn(std::move(d), "tunic", 20, 10, 0.84f), "Linen",
                {"Plain weave of thick and thin yarn, lea 25, 21 by 20 a centimetre."});
}

Design damask() {
  Design d = with_colors(figured_damask(), palette({0xf3efe4, 0xe7e0cf}), {{0, 1}}, {{1, 1}});
  Yarn yarn = spun("Linen", "Bleached linen", "40 lea", 0.238f, 480);
  yarn.irregularity = 0.03f, yarn.fibre_um = 30, yarn.groove_depth = 0.3f;
  // Beetled and calendered: flat threads, glossy along their length.
  yarn.flattening = 0.45f, yarn.lobes.along_width = 0.13f, yarn.lobes.across_width = 0.3f, yarn.lobes.layers = 7;
  d = set_at(with_yarns(std::move(d), yarn, yarn), 30, 28);
  return titled(
      lit(worn(std::move(d), "tablecloth", 8, 24, 0.76f), -50, 30), "Damask",
      {"Table damask of flowers in an ogee, for a drawloom: satin on five shafts, warp-faced against",
       "weft-faced, white on half-bleached. Lea 40, 30 by 28 a centimetre, beetled; the figure is 16 by 23 cm."});
}

Design ottoman() {
  Design d = with_colors(plain({48, 8}), palette({0x3d6e5a, 0x3a6a57}), {{0, 1}}, {{1, 1}});
  Yarn warp = boiled_off(spun("Silk", "Organzine", "84 den", 0.131f, 300)),
       weft = spun("Cotton", "Corded cotton", "Ne 5/6", 1.5f, 130, 6);
  warp.flattening = 0.5f, weft.flattening = 1;
  d = set_at(with_yarns(std::move(d), warp, weft), 66, 4.8f);
  return titled(lit(worn(std::move(d), "cushion", 6, 30, 0.78f), -20, 28), "Ottoman",
                {"Corded: a close silk warp covers thick cotton picks, 66 by 4.8 a centimetre."});
}

}  // namespace

std::vector<PresetRecipe> cloth_recipes() {
  return {
      {"cloths/linen_plain.wif", linen_plain()},
      {"cloths/silk_crepe_de_chine.wif", crepe_de_chine()},
      {"cloths/polyester_satin_charmeuse.wif", polyester_charmeuse()},
      {"cloths/cotton_denim.wif", cotton_denim()},
      {"cloths/silk_charmeuse.wif", silk_charmeuse()},
      {"cloths/cotton_twill.wif", cotton_twill()},
      {"cloths/denim.wif", denim()},
      {"cloths/chambray.wif", chambray()},
      {"cloths/oxford.wif", oxford()},
      {"cloths/gabardine.wif", gabardine()},
      {"cloths/tweed.wif", tweed()},
      {"cloths/flannel.wif", flannel()},
      {"cloths/chintz.wif", chintz()},
      {"cloths/silk_satin.wif", silk_satin()},
      {"cloths/shot_taffeta.wif", taffeta()},
      {"cloths/organza.wif", organza()},
      {"cloths/linen.wif", linen()},
      {"cloths/damask.wif", damask()},
      {"cloths/ottoman.wif", ottoman()},
  };
}

}  // namespace weftlight::wif
