#include "recipes.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <utility>

#include "../yarns.h"
#include "design/edits.h"
#include "design/fibre.h"
#include "weaves/table.h"
#include "weaves/weaves.h"

namespace weftlight::wif {

using design::Yarn, design::ready_yarns, design::with_new_palette_color, design::with_thickness,
    design::with_thread_color, design::with_thread_yarn;
using draft::Face, draft::System;
using weaves::Lean, weaves::Recipe, weaves::glen_check, weaves::herringbone, weaves::houndstooth, weaves::log_cabin,
    weaves::WeaveKind, weaves::complete_values, weaves::find_weave, weaves::make_design, weaves::plain, weaves::satin,
    weaves::shadow_weave, weaves::summer_and_winter, weaves::twill, weaves::twill_damask, weaves::undulating_twill,
    weaves::waffle, weaves::with_colors, weaves::with_pattern_yarn, weaves::with_sett;

namespace {

/// Thickness and roundness before the cloth was washed.
struct AsSpun {
  std::string_view name;
  float diameter_mm, flattening;
};
constexpr AsSpun kAsSpun[]{{"Cotton", 0.45f, 0.7f}, {"Combed cotton", 0.29f, 0.7f}, {"Mercerised cotton", 0.39f, 0.75f},
                           {"Linen", 0.52f, 0.75f}, {"Silk", 0.33f, 0.65f},         {"Wool", 0.37f, 0.75f},
                           {"Viscose", 0.22f, 0.6f}};

Yarn yarn(const char* name) { return as_spun(name); }

// Yarns first, then the sett they need.
Design in_yarns(Design design, const Yarn& warp, const Yarn& weft, float openness = 1) {
  return with_sett(with_yarns(std::move(design), warp, weft), openness);
}

// The preset spun heavier, with the same twist angle and appearance.
Yarn heavy(Yarn yarn, float diameter_mm) {
  const float scale = diameter_mm / yarn.diameter_mm;
  yarn = with_thickness(std::move(yarn), diameter_mm);
  yarn.name = "Heavy " + yarn.name;
  yarn.name[6] = static_cast<char>(std::tolower(static_cast<unsigned char>(yarn.name[6])));
  yarn.turns_per_m = std::round(yarn.turns_per_m / scale);
  yarn.fibre_um = std::round(yarn.fibre_um * std::sqrt(scale));  // grooves get wider and more numerous
  return yarn;
}

// A cool weft: colours mix in linear light, and a warm weft would turn the deep blue grey. The stars are dark at the
// edges and pale in the centre, with a golden line between them.
Design starter() {
  constexpr int kRepeat = 70;  // ends and picks of one star
  Design d = undulating_twill({3, 2, 1, 2}, 2, true, {kRepeat, kRepeat});
  d = with_colors(std::move(d), palette({0x10357a, 0x125f9c, 0x2496a8, 0x7cc4bd, 0xe6b04a, 0xd6e7ea}),
                  {{4, 1}, {0, 10}, {1, 10}, {2, 9}, {3, 11}, {2, 9}, {1, 10}, {0, 10}}, {{5, 1}});
  // Heavy yarns: a star is about 10 cm wide and visible across a table.
  d = in_yarns(std::move(d), heavy(yarn("Mercerised cotton"), 1.2f), heavy(yarn("Silk"), 1.1f));
  // Close enough to show the stars, with the edge of the table and the folds.
  d.scene.view_distance = 0.74f;
  d.scene.view_elevation = 26;
  d.scene.pan_y = -0.08f;
  return titled(std::move(d), "Tide star",
                {"An undulating twill on eight shafts, mirrored and woven as drawn in.",
                 "Heavy mercerised cotton from indigo to sea green, weft of silver silk."});
}

Design plain_weave() {
  Design d = with_colors(plain({32, 32}), palette({0xe9e1cf, 0xd8ccb4}), {{0, 1}}, {{1, 1}});
  return titled(in_yarns(std::move(d), yarn("Linen"), yarn("Linen")), "Plain weave",
                {"Over one, under one, in linen."});
}

Design twill_2_2() {
  Design d = with_colors(twill({2, 2}, Lean::kRight, {48, 48}), palette({0x3b4a3f, 0xb9ab86}), {{0, 1}}, {{1, 1}});
  return titled(in_yarns(std::move(d), yarn("Wool"), yarn("Wool")), "2/2 twill",
                {"The balanced twill of tweeds and blankets."});
}

Design satin_8() {
  Design d = with_colors(satin(8, 3, Face::kFront, {64, 64}), palette({0x0f5a4a, 0x123c33}), {{0, 1}}, {{1, 1}});
  return titled(in_yarns(std::move(d), yarn("Silk"), yarn("Silk")), "Satin on eight shafts",
                {"Warp satin, step three: each end is bound once in eight picks."});
}

Design herringbone_tweed() {
  Design d = with_colors(herringbone({2, 2}, 12, {96, 48}), palette({0x4a4540, 0xcfc6b4}), {{0, 1}}, {{1, 1}});
  return titled(in_yarns(std::move(d), yarn("Wool"), yarn("Wool")), "Herringbone",
                {"2/2 twill whose lines turn, with a break, every twelve ends."});
}

Design houndstooth_check() {
  Design d = with_colors(houndstooth({2, 2}, 4, {64, 64}), palette({0x1d1c1f, 0xf1ece0}), {}, {});
  return titled(in_yarns(std::move(d), yarn("Wool"), yarn("Wool")), "Houndstooth",
                {"2/2 twill, four dark and four light threads in both systems."});
}

Design glen() {
  Design d = with_colors(glen_check({2, 2}, {}, {192, 192}), palette({0x33363d, 0xdcd6ca}), {}, {});
  // An overcheck of one thread in each large check.
  d = with_new_palette_color(std::move(d), hex(0x7a2e2b));
  for (const int at : {24, 72, 120, 168}) {
    d = with_thread_color(std::move(d), System::kWarp, at, 2);
    d = with_thread_color(std::move(d), System::kWeft, at, 2);
  }
  return titled(in_yarns(std::move(d), yarn("Wool"), yarn("Wool")), "Glen check",
                {"Checks of four and four against two and two, with a russet overcheck."});
}

Design waffle_towel() {
  Design d = with_colors(waffle(5, {64, 64}), palette({0xf2ead9, 0xe7d9bd}), {{0, 1}}, {{1, 1}});
  // Waffles draw in more than any plain cloth: a fifth and more.
  d.plan.warp_shrinkage = d.plan.weft_shrinkage = 0.2f;
  return titled(in_yarns(std::move(d), yarn("Cotton"), yarn("Cotton")), "Waffle",
                {"Point draw on five shafts; the floats draw the cloth into cells."});
}

Design huck() {
  const WeaveKind& kind = *find_weave("huck");
  Design d = with_colors(kind.make(complete_values(kind, {}), {60, 60}).design, palette({0xf4f1e8, 0xe3ebe9}), {{0, 1}},
                         {{1, 1}});
  return titled(in_yarns(std::move(d), yarn("Linen"), yarn("Linen"), 1.25f), "Huck lace",
                {"Lace spots over a plain ground, set a little open."});
}

// Set open, so that washing can draw the threads sideways.
Design deflected() {
  const WeaveKind& kind = *find_weave("deflected");
  Design d = kind.make(complete_values(kind, {}), {96, 96}).design;
  d.draft.palette = palette({0xd6a354, 0x1f4a5c});
  d.plan.warp_shrinkage = d.plan.weft_shrinkage = 0.15f;
  d.scene.mesh = "scarf";
  return titled(in_yarns(std::move(d), heavy(yarn("Wool"), 1.2f), heavy(yarn("Wool"), 1.2f), 1.4f),
                "Deflected double weave",
                {"Stripes of two cloths float over each other; washing bends the floats round the squares."});
}

Design honeycomb() {
  const WeaveKind& kind = *find_weave("honeycomb");
  Design d = kind.make(complete_values(kind, {{"unit_size", "3"}}), {72, 72}).design;
  d.draft.palette = palette({0xeee5d3, 0x8f2f3a});
  Yarn outline = with_thickness(yarn("Wool"), 1.0f);
  outline.name = "Outline wool";
  d = with_yarns(std::move(d), yarn("Cotton"), outline);
  for (draft::Threads* threads : {&d.draft.warp, &d.draft.weft})
    std::ranges::fill(threads->thickness_mm, draft::kFromYarn);
  for (int p = 0; p < d.draft.picks(); ++p)
    if (d.draft.weft.color[static_cast<size_t>(p)] == 0) d = with_thread_yarn(std::move(d), System::kWeft, p, 0);
  d.scene.mesh = "cushion";
  return titled(with_sett(std::move(d), 1.3f), "Honeycomb",
                {"Cells of plain weave and of floats, outlined by two picks of thick wool."});
}

/// Four ends of its own in each block, as the coverlet of the figures was drafted.
Recipe coverlet() {
  Recipe out{4, {}, {{2, 3}, {0, 3}, {0, 1}, {1, 2}, {0, 2}, {1, 3}}, {}};
  for (const int block : {0, 1, 2, 3, 0, 1, 2, 3, 0, 3, 2, 1, 0, 3, 2, 1}) {
    const int other = (block + 1) % 4, even = block % 2 == 0 ? block : other, odd = block % 2 == 0 ? other : block;
    for (const int shaft : {even, odd, even, odd}) out.threading.push_back(shaft);
    for (const int treadle : {block, 4, block, 5}) out.treadling.push_back(treadle);
  }
  return out;
}

Design overshot_coverlet() {
  Design d = with_pattern_yarn(make_design(coverlet(), {128, 128}), System::kWeft, {true, false});
  d = with_colors(std::move(d), palette({0xefe6d2, 0x24365e}), {{0, 1}}, {{1, 1}, {0, 1}});
  Yarn pattern = with_thickness(yarn("Wool"), 0.72f);  // twice the tabby, to cover it
  pattern.name = "Pattern wool";
  pattern.flattening = 0.6f;
  d = with_yarns(std::move(d), yarn("Cotton"), pattern);
  for (int p = 1; p < d.draft.picks(); p += 2) d = with_thread_yarn(std::move(d), System::kWeft, p, 0);
  return titled(with_sett(std::move(d)), "Overshot",
                {"Four blocks on four shafts, tabby between the pattern picks.",
                 "Pattern weft of indigo wool over a cotton ground."});
}

Design cabin() {
  Design d = with_colors(log_cabin(16, {96, 96}), palette({0x5b2333, 0xe8d3b0}), {}, {});
  return titled(in_yarns(std::move(d), yarn("Cotton"), yarn("Cotton")), "Log cabin",
                {"Plain weave; the order of dark and light turns over every sixteen threads."});
}

Design shadow() {
  Design d = shadow_weave(
      {0, 0, 1, 1, 2, 2, 3, 3, 0, 0, 1, 1, 2, 2, 3, 3, 0, 0, 3, 3, 2, 2, 1, 1, 0, 0, 3, 3, 2, 2, 1, 1}, {64, 64});
  d = with_colors(std::move(d), palette({0x2b2f5b, 0xe9c46a}), {}, {});
  return titled(in_yarns(std::move(d), yarn("Mercerised cotton"), yarn("Mercerised cotton")), "Shadow weave",
                {"Dark and light threads in turn; blocks choose lines along or across."});
}

Design damask() {
  Design d = twill_damask({0, 0, 0, 1, 0, 1, 1, 1, 1, 1, 0, 1, 0, 0}, {112, 112});
  d = with_colors(std::move(d), palette({0xf3efe6, 0x8fa3ad}), {{0, 1}}, {{1, 1}});
  return titled(in_yarns(std::move(d), yarn("Linen"), yarn("Linen")), "Twill damask",
                {"Two blocks of four-shaft twill, 1/3 against 3/1, with a clean cut."});
}

Design shot_taffeta() {
  Design d = with_colors(plain({32, 32}), palette({0x1233a8, 0xc01226}), {{0, 1}}, {{1, 1}});
  return titled(in_yarns(std::move(d), yarn("Silk"), yarn("Silk")), "Shot taffeta",
                {"Blue warp and red weft in plain weave: the colour turns with the light."});
}

Design denim() {
  Design d = with_colors(twill({3, 1}, Lean::kRight, {48, 48}), palette({0x22304f, 0xe6e0d2}), {{0, 1}}, {{1, 1}});
  return titled(in_yarns(std::move(d), yarn("Cotton"), yarn("Cotton")), "Denim",
                {"3/1 twill, indigo warp over an ecru weft."});
}

Design gauze() {
  Design d = with_colors(plain({32, 32}), palette({0xf3d9d0, 0xf7ece4}), {{0, 1}}, {{1, 1}});
  return titled(in_yarns(std::move(d), yarn("Silk"), yarn("Silk"), 2.2f), "Gauze",
                {"Plain weave set open, so that the light comes through the gaps."});
}

Design undulating() {
  Design d = undulating_twill({2, 2, 2, 2}, 3, false, {96, 64});
  d = with_colors(std::move(d), palette({0x6d3b47, 0xe9dcc9}), {{0, 1}}, {{1, 1}});
  return titled(in_yarns(std::move(d), yarn("Viscose"), yarn("Viscose")), "Undulating twill",
                {"The twill line steepens and flattens with the crowding of the draw."});
}

Design summer_winter() {
  Design d = summer_and_winter({0, 0, 1, 0, 1, 1, 1, 1, 0, 1, 0, 0}, {96, 96});
  d = with_colors(std::move(d), palette({0xf0e7d6, 0x8c3b2a}), {{0, 1}}, {{1, 1}, {0, 1}});
  return titled(in_yarns(std::move(d), yarn("Cotton"), yarn("Wool")), "Summer and winter",
                {"Two blocks, light on the one face where dark on the other."});
}

// Double cloth of two plain weaves, dark and light, that are exchanged in squares; each square is a pocket.
// Two blocks of four shafts: dark, light, dark, light.
Design double_weave() {
  constexpr int kSquare = 24;  // threads of a square, half of them on each face
  Recipe recipe{8, {}, {}, {}};
  for (int e = 0; e < 2 * kSquare; ++e) recipe.threading.push_back(e / kSquare * 4 + e % 4);
  for (int t = 0; t < 8; ++t) {
    const bool dark = t % 2 == 0;
    std::vector<int> raised;
    for (int s = 0; s < 8; ++s) {
      const bool own = (s % 2 == 0) == dark, dark_above = s / 4 == t / 4;
      if (own ? s / 2 % 2 == t / 2 % 2 : dark != dark_above) raised.push_back(s);
    }
    recipe.tieup.push_back(raised);
  }
  for (int p = 0; p < 2 * kSquare; ++p) recipe.treadling.push_back(p / kSquare * 4 + p % 4);
  Design d = with_colors(make_design(recipe, {4 * kSquare, 4 * kSquare}), palette({0x24385c, 0xe8d9b5}),
                         {{0, 1}, {1, 1}}, {{0, 1}, {1, 1}});
  // Each layer has the sett of a plain weave.
  const Design alone = in_yarns(plain({2, 2}), yarn("Cotton"), yarn("Cotton"));
  d = with_yarns(std::move(d), yarn("Cotton"), yarn("Cotton"));
  for (const System system : {System::kWarp, System::kWeft})
    for (float& mm : d.draft.threads(system).spacing_mm) mm = 0.5f * alone.draft.threads(system).spacing_mm[0];
  return titled(
      std::move(d), "Double weave",
      {"Two plain weaves on eight shafts, one on the other; they change places in every square, which makes it a "
       "pocket."});
}

// The colours of each end start a thread earlier than those of the end before, or later, so that two groups of ends
// make an arrow. Both meet at the same place of a sequence of 33 at every 33rd end.
Design ikat() {
  constexpr int kLength = 33, kHalf = 12, kMiddle = 17;
  Design d =
      with_colors(plain({2 * kLength, 2 * kLength}), palette({0x16264f, 0x1b2c58, 0xb5472f}), {{0, 1}}, {{1, 1}});
  Yarn tied = heavy(yarn("Mercerised cotton"), 1.0f);
  const Yarn ground = tied;
  tied.name = "Tied and dyed";
  const Rgb white = hex(0xece3cd), red = hex(0xb5472f);
  tied.dye.stretches = {{11, {}, false}, {4, {}, true},     {5, white, false},
                        {4, red, false}, {5, white, false}, {4, white, true}};
  tied.dye.shift = 1, tied.dye.scatter = 1;
  Yarn other_way = tied;
  other_way.name = "Tied the other way";
  other_way.dye.shift = -1;
  d = with_yarns(std::move(d), ground, with_thickness(yarn("Mercerised cotton"), 0.35f));
  d.yarns.push_back(tied), d.yarns.push_back(other_way);
  for (int first = 0; first < 2 * kLength; first += kLength) {
    for (int i = 0; i < kHalf; ++i) {
      d = with_thread_yarn(std::move(d), System::kWarp, first + kMiddle - 1 - i, 2);
      d = with_thread_yarn(std::move(d), System::kWarp, first + kMiddle + i, 3);
    }
    for (const int stripe : {1, 32}) d = with_thread_color(std::move(d), System::kWarp, first + stripe, 2);
  }
  // A rep: the warp is so close that it covers the weft.
  d.draft.warp.spacing_mm.assign(2 * kLength, 0.85f);
  d.draft.weft.spacing_mm.assign(2 * kLength, 1.1f);
  d.scene = starter().scene;
  return titled(std::move(d), "Arrow ikat",
                {"A rep whose warp was tied and dyed before it was woven.",
                 "Each end is dyed a pick further on than the one before, so that the colours make arrows."});
}

Design swatch(const Yarn& preset) {
  Design d = with_colors(plain({16, 16}), palette({0xd8cdbb, 0xe6ddcd}), {{0, 1}}, {{1, 1}});
  return titled(in_yarns(std::move(d), preset, preset), preset.name, {"Plain weave swatch of one yarn."});
}

std::string file_name(std::string name) {
  std::transform(name.begin(), name.end(), name.begin(),
                 [](unsigned char c) { return c == ' ' ? '_' : static_cast<char>(std::tolower(c)); });
  return name + ".wif";
}

}  // namespace

Yarn as_spun(const char* name) {
  Yarn yarn = yarn_preset(name);
  for (const AsSpun& was : kAsSpun)
    if (yarn.name == was.name) yarn.diameter_mm = was.diameter_mm, yarn.flattening = was.flattening;
  return yarn;
}

std::vector<PresetRecipe> preset_recipes() {
  std::vector<PresetRecipe> all = {
      {"drafts/starter.wif", starter()},
      {"drafts/plain.wif", plain_weave()},
      {"drafts/twill_2_2.wif", twill_2_2()},
      {"drafts/satin_8.wif", satin_8()},
      {"drafts/herringbone.wif", herringbone_tweed()},
      {"drafts/houndstooth.wif", houndstooth_check()},
      {"drafts/glen_check.wif", glen()},
      {"drafts/waffle.wif", waffle_towel()},
      {"drafts/huck_lace.wif", huck()},
      {"drafts/deflected_double_weave.wif", deflected()},
      {"drafts/honeycomb.wif", honeycomb()},
      {"drafts/overshot.wif", overshot_coverlet()},
      {"drafts/log_cabin.wif", cabin()},
      {"drafts/shadow_weave.wif", shadow()},
      {"drafts/twill_damask.wif", damask()},
      {"drafts/shot_taffeta.wif", shot_taffeta()},
      {"drafts/denim.wif", denim()},
      {"drafts/gauze.wif", gauze()},
      {"drafts/undulating_twill.wif", undulating()},
      {"drafts/summer_and_winter.wif", summer_winter()},
      {"drafts/double_weave.wif", double_weave()},
      {"drafts/ikat.wif", ikat()},
  };
  // Even yarns in the drafts of the chart and of golden images.
  for (PresetRecipe& recipe : all)
    for (Yarn& yarn : recipe.design.yarns) yarn.unevenness = 0;
  for (const Yarn& preset : ready_yarns()) all.push_back({"yarns/" + file_name(preset.name), swatch(preset)});
  for (PresetRecipe& cloth : cloth_recipes()) all.push_back(std::move(cloth));
  return all;
}

}  // namespace weftlight::wif
