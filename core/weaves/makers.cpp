#include "weaves/makers.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "base/text.h"
#include "weaves/families.h"

namespace weftlight::weaves {

using base::arg, base::fill, base::tr;
using design::Design;
using draft::Draft, draft::Face, draft::kMaxShafts;

namespace {

/// A twill with its picks in another order.
Design broken_twill(const OverUnder& order, const std::vector<int>& breaks, Lean to, ClothSize size) {
  const Draft whole = twill(order, to, {1, 1}).draft;
  Recipe recipe{whole.shafts, {}, {}, {}};
  for (int s = 0; s < whole.shafts; ++s) recipe.threading.push_back(s);
  for (int t = 0; t < whole.treadles; ++t) {
    recipe.tieup.emplace_back();
    for (int s = 0; s < whole.shafts; ++s)
      if (whole.tieup.get(t, s)) recipe.tieup.back().push_back(s);
  }
  for (const int pick : breaks) recipe.treadling.push_back(pick % whole.treadles);
  return make_design(recipe, size);
}

/// A pattern line over `ends` ends, from 0 to `height` shafts.
std::vector<int> pattern_line(std::string_view form, int ends, int height) {
  std::vector<int> line;
  for (int e = 0; e < ends; ++e) {
    const double t = static_cast<double>(e) / std::max(ends, 1);
    const double wave = form == "points" ? 1 - std::abs(2 * t - 1)
                        : form == "saw"  ? t
                                         : 0.5 - 0.5 * std::cos(2 * std::numbers::pi * t);
    line.push_back(static_cast<int>(std::lround(wave * height)));
  }
  return line;
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
  const Draft whole = twill(order, lean(v), {1, 1}).draft;
  Recipe recipe{shafts, draw, {}, {}};
  for (int t = 0; t < whole.treadles; ++t) {
    recipe.tieup.emplace_back();
    for (int s = 0; s < whole.shafts; ++s)
      if (whole.tieup.get(t, s)) recipe.tieup.back().push_back(s);
    recipe.treadling.push_back(t);
  }
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
  const auto templates = block_templates();
  const std::string id = text(v, "template");
  const auto found = std::ranges::find_if(templates, [&](const BlockTemplate& t) { return id == t.id; });
  BlockTemplate unit = found != templates.end() ? *found : templates.front();
  const std::string warp = text(v, "warp"), weft = text(v, "weft");
  if (id == "own") unit = {"own", "Own", count(v, "ties"), warp.c_str(), weft.c_str()};
  auto [blocks, note] = profile(v, 8);
  GeneratedWeave made = substituted(unit, blocks, read_profile(text(v, "weft_profile")), size);
  if (made.note.empty()) made.note = std::move(note);
  return made;
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
  auto [order, note] = ratio(v);
  // Each layer has its own shafts.
  if (2 * std::accumulate(order.begin(), order.end(), 0) > kMaxShafts) {
    note =
        fill(tr("two layers of this twill need more than {most} shafts; 2/2 is used instead"), arg("most", kMaxShafts));
    order = {2, 2};
  }
  const bool wide = is(v, "kind", "double width");
  return {double_cloth(wide ? DoubleCloth::kDoubleWidth : DoubleCloth::kLayers, order, size), note};
}

}  // namespace weftlight::weaves
