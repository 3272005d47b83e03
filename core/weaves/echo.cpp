// Parallel threadings. Two warps follow one pattern line, end by end, the second some shafts above the first.
// Based on: Alice Schlein, Network Drafting: An Introduction, 1994; Marian Stubenitsky, Weaving with Echo and Iris,
// 2014.

#include <algorithm>
#include <numeric>

#include "weaves/families.h"
#include "weaves/makers.h"

namespace weftlight::weaves {

namespace {

/// Straight over the treadles, or in the order of the pattern line.
std::vector<int> treadling_of(const WeaveValues& v, const std::vector<int>& line, int treadles) {
  if (is(v, "treadling", "as drawn in")) return line;
  std::vector<int> order(static_cast<size_t>(treadles));
  std::iota(order.begin(), order.end(), 0);
  return order;
}

/// The two warps light and dark, the weft of a third colour.
Design in_three_colors(Design design) {
  std::vector<Rgb> palette = design.draft.palette;
  palette.push_back({0.5f, 0.5f, 0.5f});
  return with_colors(std::move(design), std::move(palette), {{0, 1}, {1, 1}}, {{2, 1}});
}

}  // namespace

std::vector<int> parallel_threading(const std::vector<int>& line, int interval, int shafts) {
  std::vector<int> threading;
  for (const int shaft : line) {
    threading.push_back(shaft);
    threading.push_back((shaft + interval) % shafts);
  }
  return threading;
}

GeneratedWeave make_echo(const WeaveValues& v, ClothSize size) {
  auto [order, note] = ratio(v);
  const int shafts = std::accumulate(order.begin(), order.end(), 0);
  const std::vector<int> line =
      network_threading({0, 1, 2, 3}, pattern_line(text(v, "line"), count(v, "length"), count(v, "height")), shafts);
  Recipe recipe = twill_recipe(order, lean(v));
  recipe.threading = parallel_threading(line, count(v, "interval"), shafts);
  recipe.treadling = treadling_of(v, line, shafts);
  return {in_three_colors(make_design(recipe, size)), std::move(note)};
}

GeneratedWeave make_jin(const WeaveValues& v, ClothSize size) {
  const int shafts = std::max(count(v, "shafts") / 4, 1) * 4, half = shafts / 2;
  // An even number of ends in the line, so that odd and even shafts alternate over the repeat, too.
  const int length = std::max(count(v, "length") + 1, 2) / 2 * 2;
  const std::vector<int> line =
      network_threading({0, 1}, pattern_line(text(v, "line"), length, count(v, "height")), shafts);
  Recipe recipe = twill_recipe({half, half}, Lean::kRight);
  recipe.threading = parallel_threading(line, half, shafts);
  for (const int odd : {0, 1}) {
    recipe.tieup.emplace_back();
    for (int s = odd; s < shafts; s += 2) recipe.tieup.back().push_back(s);
  }
  recipe.treadling.clear();
  for (const int treadle : treadling_of(v, line, shafts))
    for (const int next : {treadle, shafts + static_cast<int>(recipe.treadling.size()) / 2 % 2})
      recipe.treadling.push_back(next);
  return {in_three_colors(make_design(recipe, size)), {}};
}

}  // namespace weftlight::weaves
