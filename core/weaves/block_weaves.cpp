// Block weaves: groups of threads that weave alike, in an order chosen by the weaver; and colour-and-weave effects.

#include <algorithm>
#include <cstdlib>

#include "base/mark.h"
#include "design/fibre.h"
#include "weaves/weaves.h"

namespace weftlight::weaves {

using design::Design, design::Yarn, design::with_thickness;
using draft::Rgb, draft::kMaxThreads;

namespace {

std::vector<int> in_range(std::vector<int> blocks, int count) {
  if (blocks.empty()) blocks = {0};
  for (int& block : blocks) block = std::clamp(block, 0, count - 1);
  return blocks;
}

int last_block(const std::vector<int>& blocks) { return *std::max_element(blocks.begin(), blocks.end()); }

std::vector<int> point(int n) {
  std::vector<int> order;
  for (int i = 0; i < n; ++i) order.push_back(i);
  for (int i = n - 2; i > 0; --i) order.push_back(i);
  return order;
}

// The even or the odd one of the two shafts of overshot block b: b and b + 1, cyclic.
int shaft_of_block(int b, bool odd) {
  const int next = (b + 1) % 4;
  return (b % 2 == 1) == odd ? b : next;
}

}  // namespace

Design waffle(int shafts, ClothSize size) {
  const int n = std::clamp(shafts, 4, 64);
  // Single ties on the diagonal draw diamonds. Within one diamond the warp floats, within the next the weft; the line
  // of weft beside the diagonal separates them.
  std::vector<std::vector<int>> tieup(static_cast<size_t>(n));
  for (int t = 0; t < n; ++t) {
    for (int s = 0; s < n; ++s) {
      if (s == t || s > t + 1) tieup[t].push_back(s);
    }
  }
  return make_design({n, point(n), tieup, point(n)}, size);
}

Design huck_lace(ClothSize size) {
  // Shafts 0 (outer) and 2 make one half unit, 1 (outer) and 3 the other. Tabbies {0, 3} and {1, 2}; a lace
  // pick is a tabby without the inner ends of a half unit, so that the weft floats over all five.
  const std::vector<std::vector<int>> tieup = {{1}, {0, 3}, {0}, {1, 2}};
  return make_design({4, {0, 2, 0, 2, 0, 1, 3, 1, 3, 1}, tieup, {0, 1, 0, 1, 0, 2, 3, 2, 3, 2}}, size);
}

Design overshot(const std::vector<int>& blocks, int length, ClothSize size) {
  const std::vector<int> order = in_range(blocks, 4);
  const int ends = std::clamp(length, 2, 64);
  Recipe recipe{4, {}, {{2, 3}, {0, 3}, {0, 1}, {1, 2}, {0, 2}, {1, 3}}, {}};
  for (const int block : order) {
    for (int i = 0; i < ends; ++i) {
      recipe.threading.push_back(shaft_of_block(block, recipe.threading.size() % 2 == 1));
    }
    for (int i = 0; i < std::max(1, ends / 2); ++i) {
      // The shafts of the block stay down, so that the pattern weft floats over it; the tabbies alternate.
      recipe.treadling.push_back(block);
      recipe.treadling.push_back(4 + (static_cast<int>(recipe.treadling.size()) / 2) % 2);
    }
  }
  Design design = make_design(recipe, size);
  Yarn pattern = with_thickness(design.yarns[0], 1.6f * design.yarns[0].diameter_mm);  // covers the tabby
  pattern.name = base::mark("Pattern weft");
  pattern.flattening = 0.6f;  // soft and little twisted, so that it spreads
  design.yarns.push_back(pattern);
  for (int p = 0; p < design.draft.picks(); p += 2) design.draft.weft.yarn[p] = 1;
  return with_sett(std::move(design));
}

Design summer_and_winter(const std::vector<int>& blocks, ClothSize size) {
  const std::vector<int> order = in_range(blocks, 32);
  const int count = last_block(order) + 1;
  Recipe recipe{2 + count, {}, {}, {}};
  std::vector<int> pattern_shafts;
  for (int b = 0; b < count; ++b) pattern_shafts.push_back(2 + b);
  recipe.tieup = {{0, 1}, pattern_shafts};
  for (int b = 0; b < count; ++b) {
    for (const int tie : {0, 1}) {
      std::vector<int> shafts = {tie};
      for (const int s : pattern_shafts) {
        if (s != 2 + b) shafts.push_back(s);
      }
      recipe.tieup.push_back(shafts);
    }
  }
  for (const int block : order) {
    for (const int shaft : {0, 2 + block, 1, 2 + block}) recipe.threading.push_back(shaft);
    const int tied = 2 + 2 * block;
    for (const int treadle : {tied, 0, tied + 1, 1}) recipe.treadling.push_back(treadle);
  }
  return make_design(recipe, size);
}

Design twill_damask(const std::vector<int>& blocks, ClothSize size) {
  const std::vector<int> order = in_range(blocks, 2);
  Recipe recipe{8, {}, {}, {}};
  for (int weft_block = 0; weft_block < 2; ++weft_block) {
    for (int t = 0; t < 4; ++t) {
      std::vector<int> shafts;
      for (int s = 0; s < 8; ++s) {
        // 1/3 twill against 3/1 twill of the other direction: across a border each thread weaves opposite to its
        // neighbour.
        const bool warp_face = s / 4 != weft_block;
        if (warp_face ? s % 4 != 3 - t : s % 4 == t) shafts.push_back(s);
      }
      recipe.tieup.push_back(shafts);
    }
  }
  for (const int block : order) {
    for (int i = 0; i < 4; ++i) {
      recipe.threading.push_back(4 * block + i);
      recipe.treadling.push_back(4 * block + i);
    }
  }
  return make_design(recipe, size);
}

Design shadow_weave(const std::vector<int>& blocks, ClothSize size) {
  const std::vector<int> order = in_range(blocks, 4);
  // Shafts and treadles 0..3 are those of the dark threads of the blocks, 4..7 of the light ones. A dark pick lifts the
  // dark ends where lines run across and the light ends where they run along; a light pick the opposite.
  Recipe recipe{8, {}, {}, {}};
  for (int treadle = 0; treadle < 8; ++treadle) {
    std::vector<int> shafts;
    for (int s = 0; s < 8; ++s) {
      const bool across = (s % 4 - treadle % 4 + 4) % 4 < 2;
      if (((s < 4) == across) == (treadle < 4)) shafts.push_back(s);
    }
    recipe.tieup.push_back(shafts);
  }
  for (const int block : order) {
    for (const int shade : {0, 4}) {
      recipe.threading.push_back(block + shade);
      recipe.treadling.push_back(block + shade);
    }
  }
  Design design = make_design(recipe, size);
  const std::vector<Rgb> palette = design.draft.palette;
  return with_colors(std::move(design), palette, {{0, 1}, {1, 1}}, {{0, 1}, {1, 1}});
}

Design log_cabin(int block, ClothSize size) {
  const int pairs = std::clamp(block / 2, 1, kMaxThreads / 4);
  std::vector<Stripe> order;
  for (const int first : {0, 1}) {
    for (int i = 0; i < pairs; ++i) {
      order.push_back({first, 1});
      order.push_back({1 - first, 1});
    }
  }
  Design design = plain(size);
  const std::vector<Rgb> palette = design.draft.palette;
  return with_colors(std::move(design), palette, order, order);
}

Design houndstooth(ClothSize size) {
  Design design = twill({2, 2}, Lean::kRight, size);
  const std::vector<Rgb> palette = design.draft.palette;
  return with_colors(std::move(design), palette, {{0, 4}, {1, 4}}, {{0, 4}, {1, 4}});
}

Design glen_check(ClothSize size) {
  std::vector<Stripe> order;
  for (int i = 0; i < 6; ++i) order.insert(order.end(), {{0, 4}, {1, 4}});
  for (int i = 0; i < 12; ++i) order.insert(order.end(), {{0, 2}, {1, 2}});
  Design design = twill({2, 2}, Lean::kRight, size);
  const std::vector<Rgb> palette = design.draft.palette;
  return with_colors(std::move(design), palette, order, order);
}

}  // namespace weftlight::weaves
