#include "weaves/makers.h"

#include <algorithm>
#include <array>
#include <numeric>

#include "base/text.h"
#include "weaves/families.h"

namespace weftlight::weaves {

using base::arg, base::fill, base::tr;
using design::Design;
using draft::BitMatrix, draft::Face, draft::kMaxShafts;

namespace {

/// A twill with its picks in another order.
Design broken_twill(const OverUnder& order, const std::vector<int>& breaks, Lean to, ClothSize size) {
  Recipe recipe = twill_recipe(order, to);
  recipe.treadling.clear();
  for (const int pick : breaks) recipe.treadling.push_back(pick % recipe.shafts);
  return make_design(recipe, size);
}

/// The ratio of each layer, which has shafts of its own.
Noted<OverUnder> ratio_of_layers(const WeaveValues& v, int layers) {
  Noted<OverUnder> read = ratio(v);
  if (layers * std::accumulate(read.value.begin(), read.value.end(), 0) <= kMaxShafts) return read;
  return {
      {2, 2},
      fill(tr("the layers of this twill need more than {most} shafts; 2/2 is used instead"), arg("most", kMaxShafts))};
}

}  // namespace

GeneratedWeave make_broken(const WeaveValues& v, ClothSize size) {
  const auto [order, note] = ratio(v);
  const int shafts = std::accumulate(order.begin(), order.end(), 0);
  Noted<std::vector<int>> read = read_sequence(text(v, "order"), shafts);
  if (read.value.empty()) read.value = {0, 1, 3, 2};
  return {broken_twill(order, read.value, lean(v), size), read.note.empty() ? note : read.note};
}

GeneratedWeave make_satin(const WeaveValues& v, ClothSize size) {
  const int shafts = count(v, "shafts"), wanted = count(v, "step");
  const std::vector<int> steps = satin_steps(shafts);
  if (steps.empty())
    return {twill({shafts - 1, 1}, Lean::kRight, size),
            fill(tr("there is no satin on {shafts} shafts; a twill is used instead"), arg("shafts", shafts))};
  const int step = *std::ranges::min_element(steps, {}, [wanted](int s) { return std::abs(s - wanted); });
  GeneratedWeave made{satin(shafts, step, is(v, "face", "weft") ? Face::kBack : Face::kFront, size), {}};
  if (step == wanted) return made;
  std::string list;
  for (const int s : steps) list.append(list.empty() ? "" : " ").append(std::to_string(s));
  made.note = fill(tr("a satin on {shafts} shafts has the steps {steps}; {step} is used"), arg("shafts", shafts),
                   arg("steps", list), arg("step", step));
  return made;
}

GeneratedWeave make_network(const WeaveValues& v, ClothSize size) {
  auto [order, note] = ratio(v);
  const int shafts = std::accumulate(order.begin(), order.end(), 0);
  auto [initial, unread] = read_sequence(text(v, "initial"), 16);
  if (!unread.empty() || initial.empty()) {
    note = fill(tr("'{text}' is not an initial such as 1-4, which is used instead"), arg("text", text(v, "initial")));
    initial = {0, 1, 2, 3};
  }
  const int rows = *std::ranges::max_element(initial) + 1;
  initial.resize(static_cast<size_t>(std::max(rows, static_cast<int>(initial.size()))), 0);
  const std::vector<int> draw =
      network_threading(initial, pattern_line(text(v, "line"), count(v, "length"), count(v, "height")), shafts);
  Recipe recipe = twill_recipe(order, lean(v));
  recipe.threading = draw;
  if (is(v, "treadling", "as drawn in")) recipe.treadling = draw;
  return {make_design(recipe, size), note};
}

/// Blocks A 1232, B 2343, C 3414, D 4121. Between two blocks the first thread of the old one is repeated, so that no
/// two adjacent ends are both odd or both even. Based on: Mary Snyder, The Crackle Weave, 1961.
GeneratedWeave make_crackle(const WeaveValues& v, ClothSize size) {
  const auto [blocks, note] = profile(v, 4);
  Recipe recipe{4, {}, {{2, 3}, {0, 3}, {0, 1}, {1, 2}, {0, 2}, {1, 3}}, {}};
  for (size_t i = 0; i < blocks.size(); ++i) {
    const int block = blocks[i], next = blocks[(i + 1) % blocks.size()];
    for (const int step : {0, 1, 2, 1}) recipe.threading.push_back((block + step) % 4);
    // The shorter way from block to block.
    const int distance = (next - block + 4) % 4;
    for (int k = 0; k < (distance == 3 ? 1 : distance); ++k) recipe.threading.push_back((block + k) % 4);
  }
  for (const int block : blocks)
    for (int i = 0; i < count(v, "picks"); ++i) {
      recipe.treadling.push_back(block);
      recipe.treadling.push_back(4 + static_cast<int>(recipe.treadling.size()) / 2 % 2);
    }
  return {make_design(recipe, size), note};
}

GeneratedWeave make_substitution(const WeaveValues& v, ClothSize size) {
  const std::string id = text(v, "template"), warp = text(v, "warp"), weft = text(v, "weft");
  if (id == "own")
    return make_units(std::array{BlockTemplate{"own", count(v, "ties"), warp.c_str(), weft.c_str()}}, v, size);
  const auto templates = block_templates();
  const auto found = std::ranges::find_if(templates, [&](const BlockTemplate& t) { return id == t.id; });
  return make_units({found != templates.end() ? found : templates.begin(), 1}, v, size);
}

GeneratedWeave make_sections(const WeaveValues& v, ClothSize size) {
  GeneratedWeave made;
  const int shafts = count(v, "shafts");
  Recipe recipe{shafts, {}, {}, {}};
  // `problem`: pattern of the message.
  const auto read = [&](const char* id, const char* problem, int most) {
    Noted<std::vector<int>> r = read_sequence(text(v, id), most);
    if (!r.note.empty() && made.note.empty()) made.note = fill(problem, arg("problem", r.note));
    return r.value.empty() ? std::vector<int>{0} : std::move(r.value);
  };
  recipe.threading = read("threading", tr("threading: {problem}"), shafts);
  std::string treadle;
  const std::string ties = text(v, "tieup") + "|";
  for (const char c : ties) {
    if (c != '|') {
      treadle += c;
      continue;
    }
    Noted<std::vector<int>> r = read_sequence(treadle, shafts);
    if (!r.note.empty() && made.note.empty()) made.note = fill(tr("tie-up: {problem}"), arg("problem", r.note));
    recipe.tieup.push_back(std::move(r.value));
    treadle.clear();
    if (recipe.tieup.size() >= static_cast<size_t>(kMaxShafts)) break;
  }
  recipe.treadling = read("treadling", tr("treadling: {problem}"), static_cast<int>(recipe.tieup.size()));
  made.design = make_design(recipe, size);
  return made;
}

GeneratedWeave make_sett(const WeaveValues& v, ClothSize size) {
  const auto [order, note] = ratio(v);
  const auto [sett, unread] = read_sett(text(v, "sett"));
  GeneratedWeave made{twill(order, lean(v), size), unread.empty() ? note : unread};
  if (!sett.palette.empty())
    made.design = with_colors(std::move(made.design), sett.palette, sett.stripes, sett.stripes);
  return made;
}

GeneratedWeave make_double(const WeaveValues& v, ClothSize size) {
  const int layers = is(v, "kind", "tube") ? 2 : count(v, "layers");
  auto [order, note] = ratio_of_layers(v, layers);
  const DoubleCloth kind = is(v, "kind", "double width") ? DoubleCloth::kDoubleWidth
                           : is(v, "kind", "tube")       ? DoubleCloth::kTube
                                                         : DoubleCloth::kLayers;
  return {double_cloth(kind, order, size, layers), note};
}

GeneratedWeave make_stitched(const WeaveValues& v, ClothSize size) {
  auto [order, note] = ratio_of_layers(v, 2);
  return {stitched_cloth(order, count(v, "stitches"), is(v, "stitch", "lower ends rise"), size), note};
}

GeneratedWeave make_overshot(const WeaveValues& v, ClothSize size) {
  auto [blocks, note] = profile(v, kMaxBlocks, "profile", 2);
  const bool as_writ = is(v, "treadling", "tromp as writ");
  return {overshot(blocks, count(v, "block"), size, {is(v, "fashion", "rose"), as_writ, count(v, "picks")}), note};
}

GeneratedWeave make_glen_check(const WeaveValues& v, ClothSize size) {
  auto [order, note] = ratio(v);
  const GlenCheck check{count(v, "threads"), count(v, "pairs"), count(v, "fine_threads"), count(v, "fine_pairs"),
                        count(v, "overcheck")};
  return {glen_check(order, check, size), note};
}

GeneratedWeave make_iso(const WeaveValues& v, ClothSize size) {
  const base::Result<BitMatrix> repeat = read_iso_code(text(v, "code"));
  if (!repeat) return {plain(size), problem_of(repeat)};  // a stand-in: check_values() keeps it from becoming a draft
  return {make_design(recipe_of(*repeat), size), {}};
}

}  // namespace weftlight::weaves
