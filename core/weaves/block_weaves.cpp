// Block weaves: groups of threads that weave alike, in an order chosen by the weaver; and colour-and-weave effects.

#include <algorithm>
#include <cstdlib>

#include "weaves/weaves.h"

namespace weftlight::weaves {

using design::Design;
using draft::Rgb, draft::System, draft::kMaxThreads;

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

// The even or the odd one of the two shafts of overshot block b: b and b + 1 round the shafts.
int shaft_of_block(int b, bool odd, int shafts) { return (b % 2 == 1) == odd ? b : (b + 1) % shafts; }

// The shafts lifted while the pattern weft covers block b. Those of the block stay down. Every second of the others
// rises, the first and the last too: the neighbours of b share a shaft with it and bind the weft with the other one.
std::vector<int> lifts_of_block(int b, int shafts) {
  std::vector<int> lifts;
  for (int k = 2; k < shafts; ++k)
    if (k % 2 == 0 || k == shafts - 1) lifts.push_back((b + k) % shafts);
  std::ranges::sort(lifts);
  return lifts;
}

// The blocks that the pattern picks cover, in their order.
std::vector<int> pattern_picks(const std::vector<int>& blocks, int ends, const std::vector<int>& threading, int shafts,
                               const OvershotTreadling& how) {
  std::vector<int> order;
  if (how.as_writ) {
    // Two neighbouring ends are the block of the lower one, also where a block was skipped.
    for (size_t i = 0; i < threading.size(); ++i) {
      const int a = threading[i], b = threading[(i + 1) % threading.size()];
      order.push_back((b + 1) % shafts == a ? b : (a + 1) % shafts == b ? a : std::min(a, b));
    }
  } else {
    const int picks = how.picks > 0 ? std::min(how.picks, 64) : std::max(1, ends / 2);
    for (const int block : blocks) order.insert(order.end(), static_cast<size_t>(picks), block);
  }
  const int used = last_block(blocks) + 1;
  if (how.rose)
    for (int& block : order)
      if ((block ^ 1) < used) block ^= 1;
  if (order.size() % 2 == 0) return order;
  // The tabby alternates, also from repeat to repeat.
  std::vector<int> twice = order;
  twice.insert(twice.end(), order.begin(), order.end());
  return twice;
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

Design overshot(const std::vector<int>& blocks, int length, ClothSize size, OvershotTreadling treadling) {
  const std::vector<int> order = in_range(blocks, 32);
  const int ends = std::clamp(length, 2, 64), shafts = std::max(4, (last_block(order) + 2) / 2 * 2);
  Recipe recipe{shafts, {}, {}, {}};
  const auto add_end = [&](int block) {
    recipe.threading.push_back(shaft_of_block(block, recipe.threading.size() % 2 == 1, shafts));
  };
  // Each block ends on the shaft on which it began: it shares the next block's first end where the profile goes on, and
  // is the same both ways where the profile turns.
  for (auto block = order.begin(); block != order.end();) {
    const auto next = std::find_if(block, order.end(), [&](int other) { return other != *block; });
    const int of_run = static_cast<int>(next - block) * ends;
    for (int i = 0; i < of_run - (of_run % 2 == 0 ? 1 : 0); ++i) add_end(*block);
    block = next;
  }
  if (recipe.threading.size() % 2 == 1) add_end(order.back());  // odd and even ends alternate over the repeat, too
  for (int b = 0; b < shafts; ++b) recipe.tieup.push_back(lifts_of_block(b, shafts));
  for (const int odd : {0, 1}) {
    recipe.tieup.emplace_back();
    for (int s = odd; s < shafts; s += 2) recipe.tieup.back().push_back(s);
  }
  for (const int block : pattern_picks(order, ends, recipe.threading, shafts, treadling)) {
    recipe.treadling.push_back(block);
    recipe.treadling.push_back(shafts + static_cast<int>(recipe.treadling.size()) / 2 % 2);
  }
  return with_pattern_yarn(make_design(recipe, size), System::kWeft, {true, false});
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

Design houndstooth(const OverUnder& order, int threads, ClothSize size) {
  Design design = twill(order, Lean::kRight, size);
  const std::vector<Rgb> palette = design.draft.palette;
  const std::vector<Stripe> stripes = {{0, threads}, {1, threads}};
  return with_colors(std::move(design), palette, stripes, stripes);
}

Design glen_check(const OverUnder& order, const GlenCheck& check, ClothSize size) {
  std::vector<int> colors;
  const auto add_pairs = [&colors](int threads, int pairs) {
    for (int i = 0; i < 2 * std::clamp(pairs, 1, 64); ++i)
      colors.insert(colors.end(), static_cast<size_t>(std::clamp(threads, 1, 64)), i % 2);
  };
  add_pairs(check.threads, check.pairs);
  const size_t over = std::min(static_cast<size_t>(std::max(check.overcheck, 0)), colors.size());
  std::fill_n(colors.begin() + static_cast<std::ptrdiff_t>((colors.size() - over) / 2), over, 2);
  add_pairs(check.fine_threads, check.fine_pairs);
  std::vector<Stripe> stripes;
  for (const int color : colors) stripes.push_back({color, 1});
  Design design = twill(order, Lean::kRight, size);
  std::vector<Rgb> palette = design.draft.palette;
  if (over > 0) palette.push_back({0.55f, 0.16f, 0.12f});  // russet
  return with_colors(std::move(design), palette, stripes, stripes);
}

}  // namespace weftlight::weaves
