#include "design/palette_edits.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <numeric>
#include <tuple>
#include <utility>

#include "design/fibre.h"
#include "design/oklab.h"
#include "draft/hex_color.h"

namespace weftlight::design {

using draft::kMaxColors, draft::packed_rgb;

namespace {

bool within(int index, size_t count) { return index >= 0 && static_cast<size_t>(index) < count; }

/// Which of the two tables of threads.
using Column = std::vector<int> Threads::*;

/// Calls `use` for that column of the draft and of all sections.
template <class AnyDesign, class Use>
void each_column(AnyDesign& design, Column column, Use use) {
  use(design.draft.warp.*column);
  use(design.draft.weft.*column);
  for (auto* assembly : {&design.warp_assembly, &design.weft_assembly})
    for (auto& section : assembly->sections) use(section.threads.*column);
}

std::vector<int> uses(const Design& design, Column column, size_t count) {
  std::vector<int> sum(count, 0);
  each_column(design, column, [&](const std::vector<int>& threads) {
    for (const int i : threads) ++sum[within(i, count) ? static_cast<size_t>(i) : 0];
  });
  return sum;
}

/// `now`: for each entry of the old list its number in the new one. What is not in the list counts as the first.
void renumber(Design& design, Column column, const std::vector<int>& now) {
  each_column(design, column, [&](std::vector<int>& threads) {
    for (int& i : threads) i = now[within(i, now.size()) ? static_cast<size_t>(i) : 0];
  });
}

/// The list with the entries that `heirs` leaves to themselves; the others are replaced by their heirs.
template <class T>
void keep(Design& design, std::vector<T>& list, Column column, const std::vector<int>& heirs) {
  std::vector<T> kept;
  std::vector<int> now(list.size());
  for (size_t i = 0; i < list.size(); ++i) {
    if (heirs[i] != static_cast<int>(i)) continue;
    now[i] = static_cast<int>(kept.size());
    kept.push_back(list[i]);
  }
  for (size_t i = 0; i < list.size(); ++i) now[i] = now[static_cast<size_t>(heirs[i])];
  renumber(design, column, now);
  list = std::move(kept);
}

std::vector<int> own_heirs(size_t count) {
  std::vector<int> heirs(count);
  std::iota(heirs.begin(), heirs.end(), 0);
  return heirs;
}

template <class T>
void leave_out(Design& design, std::vector<T>& list, Column column, int entry, int heir) {
  if (!within(entry, list.size()) || !within(heir, list.size()) || entry == heir) return;
  std::vector<int> heirs = own_heirs(list.size());
  heirs[static_cast<size_t>(entry)] = heir;
  keep(design, list, column, heirs);
}

/// Unused entries go, their heir is the first that stays.
std::vector<int> heirs_of_unused(const std::vector<int>& uses) {
  std::vector<int> heirs = own_heirs(uses.size());
  const auto used = std::ranges::find_if(uses, [](int n) { return n > 0; });
  const int first = used == uses.end() ? 0 : static_cast<int>(used - uses.begin());
  for (size_t i = 0; i < uses.size(); ++i)
    if (uses[i] == 0) heirs[i] = first;
  return heirs;
}

/// The list sorted by what `rank` says of an entry; equals stay in their order.
template <class T, class Rank>
void reorder(Design& design, std::vector<T>& list, Column column, Rank rank) {
  std::vector<int> order = own_heirs(list.size()), now(list.size());
  std::ranges::stable_sort(order, {}, [&](int i) { return std::invoke(rank, list[static_cast<size_t>(i)]); });
  std::vector<T> sorted;
  for (const int old : order) {
    now[static_cast<size_t>(old)] = static_cast<int>(sorted.size());
    sorted.push_back(list[static_cast<size_t>(old)]);
  }
  renumber(design, column, now);
  list = std::move(sorted);
}

/// Yarns of no thread in the draft are bought no longer.
void forget_purchases(Design& design) {
  std::erase_if(design.plan.purchases, [&](const YarnPurchase& bought) {
    return std::ranges::find(design.yarns, bought.yarn, &Yarn::name) == design.yarns.end();
  });
}

/// Colours with less of a hue are greys.
constexpr float kGreyChroma = 0.02f;

/// Greys first, light to dark; then around the circle of hues from red on, in twelve parts, each from light to dark.
std::tuple<int, float> hue_rank(Rgb color) {
  const Oklab lab = oklab_of(color);
  if (std::hypot(lab.a, lab.b) < kGreyChroma) return {-1, -lab.lightness};
  constexpr float kTurn = 6.2831853f, kParts = 12;
  const float hue = std::atan2(lab.b, lab.a) / kTurn;  // -1/2..1/2; red is near 0.08
  return {static_cast<int>(std::floor((hue < 0 ? hue + 1 : hue) * kParts)), -lab.lightness};
}

/// Length of the stripes: the smallest p such that each colour is that of p threads before (Knuth, Morris, Pratt 1977).
size_t stripes(const std::vector<int>& colors) {
  std::vector<size_t> border(colors.size() + 1, 0);
  for (size_t i = 1, k = 0; i < colors.size(); ++i) {
    while (k > 0 && colors[i] != colors[k]) k = border[k];
    if (colors[i] == colors[k]) ++k;
    border[i + 1] = k;
  }
  return colors.size() - border.back();
}

std::vector<int> continued(const std::vector<int>& colors, size_t threads) {
  const size_t period = stripes(colors);
  std::vector<int> out(threads, 0);
  for (size_t i = 0; i < threads && period > 0; ++i) out[i] = colors[i % period];
  return out;
}

/// The numbers of the colours in the palette, which gets those that it lacks. Empty if there is no room.
std::vector<int> in_palette(std::vector<Rgb>& palette, const std::vector<Rgb>& colors) {
  std::map<uint32_t, int> known;
  for (size_t i = 0; i < palette.size(); ++i) known.try_emplace(packed_rgb(palette[i]), static_cast<int>(i));
  std::vector<int> numbers;
  for (const Rgb& color : colors) {
    const auto [at, is_new] = known.try_emplace(packed_rgb(color), static_cast<int>(palette.size()));
    if (is_new) palette.push_back(color);
    numbers.push_back(at->second);
  }
  return palette.size() <= static_cast<size_t>(kMaxColors) ? numbers : std::vector<int>{};
}

/// Which of the steps each of the threads has. Blended: the step before or after its place, in such an alternation that
/// the sum of all threads up to it is that of their places (error diffusion).
std::vector<int> steps_of(size_t threads, int steps, bool blended) {
  std::vector<int> out;
  double owed = 0;
  for (size_t i = 0; i < threads; ++i) {
    const double middle = (static_cast<double>(i) + 0.5) / static_cast<double>(threads);
    if (!blended) {
      out.push_back(static_cast<int>(middle * steps));
      continue;
    }
    owed += middle * (steps - 1);
    const int step = std::clamp(static_cast<int>(std::floor(owed + 0.5)), 0, steps - 1);
    owed -= step;
    out.push_back(step);
  }
  return out;
}

}  // namespace

int closest_color(const Design& design, int color) {
  const auto& palette = design.draft.palette;
  int best = -1;
  if (!within(color, palette.size())) return best;
  float least = std::numeric_limits<float>::max();
  for (size_t i = 0; i < palette.size(); ++i) {
    const float distance = color_distance(palette[i], palette[static_cast<size_t>(color)]);
    if (static_cast<int>(i) != color && distance < least) least = distance, best = static_cast<int>(i);
  }
  return best;
}

int closest_yarn(const Design& design, int yarn) {
  int best = -1;
  if (!within(yarn, design.yarns.size())) return best;
  const Yarn& gone = design.yarns[static_cast<size_t>(yarn)];
  constexpr float kOtherFibre = 1000;
  float least = std::numeric_limits<float>::max();
  for (size_t i = 0; i < design.yarns.size(); ++i) {
    const Yarn& other = design.yarns[i];
    const float octaves = std::abs(std::log2(std::max(tex_of(other), 0.01f) / std::max(tex_of(gone), 0.01f)));
    const float distance = octaves + (other.fibre == gone.fibre ? 0 : kOtherFibre);
    if (static_cast<int>(i) != yarn && distance < least) least = distance, best = static_cast<int>(i);
  }
  return best;
}

std::vector<int> uses_of_colors(const Design& design) {
  return uses(design, &Threads::color, std::max<size_t>(design.draft.palette.size(), 1));
}

std::vector<int> uses_of_yarns(const Design& design) { return uses(design, &Threads::yarn, design.yarns.size()); }

Design without_color(Design design, int color, int heir) {
  leave_out(design, design.draft.palette, &Threads::color, color, heir);
  return design;
}

Design without_yarn(Design design, int yarn, int heir) {
  leave_out(design, design.yarns, &Threads::yarn, yarn, heir);
  forget_purchases(design);
  return design;
}

Design with_merged_colors(Design design) {
  const auto& palette = design.draft.palette;
  std::vector<int> heirs = own_heirs(palette.size());
  std::map<uint32_t, int> first;
  for (size_t i = 0; i < palette.size(); ++i)
    heirs[i] = first.try_emplace(packed_rgb(palette[i]), heirs[i]).first->second;
  keep(design, design.draft.palette, &Threads::color, heirs);
  return design;
}

Design with_merged_yarns(Design design) {
  const auto& yarns = design.yarns;
  std::vector<int> heirs = own_heirs(yarns.size());
  for (size_t i = 0; i < yarns.size(); ++i)
    heirs[i] = static_cast<int>(std::ranges::find(yarns, yarns[i]) - yarns.begin());
  keep(design, design.yarns, &Threads::yarn, heirs);
  return design;
}

Design without_unused_colors(Design design) {
  if (!design.draft.palette.empty())
    keep(design, design.draft.palette, &Threads::color, heirs_of_unused(uses_of_colors(design)));
  return design;
}

Design without_unused_yarns(Design design) {
  keep(design, design.yarns, &Threads::yarn, heirs_of_unused(uses_of_yarns(design)));
  forget_purchases(design);
  return design;
}

Design with_sorted_colors(Design design, ColorOrder order) {
  reorder(design, design.draft.palette, &Threads::color, [&](const Rgb& color) {
    return order == ColorOrder::kHue ? hue_rank(color) : std::tuple(0, -oklab_of(color).lightness);
  });
  return design;
}

Design with_sorted_yarns(Design design) {
  reorder(design, design.yarns, &Threads::yarn, &Yarn::name);
  return design;
}

Design with_swapped_systems(Design design) {
  std::vector<int>&warp = design.draft.warp.color, &weft = design.draft.weft.color;
  std::vector<int> ends = continued(weft, warp.size());
  weft = continued(warp, weft.size());
  warp = std::move(ends);
  return design;
}

namespace {

/// Colours that are seen in the cloth: of the palette those that threads have, and the dyes of their yarns.
std::vector<Rgb*> seen_colors(Design& design) {
  auto& palette = design.draft.palette;
  std::vector<bool> colors(palette.size()), yarns(design.yarns.size());
  const auto mark_used = [](const std::vector<int>& numbers, std::vector<bool>& used) {
    for (const int i : numbers)
      if (within(i, used.size())) used[static_cast<size_t>(i)] = true;
  };
  for (const Threads* threads : {&design.draft.warp, &design.draft.weft})
    mark_used(threads->color, colors), mark_used(threads->yarn, yarns);
  std::vector<Rgb*> seen;
  for (size_t i = 0; i < palette.size(); ++i)
    if (colors[i]) seen.push_back(&palette[i]);
  for (size_t i = 0; i < yarns.size(); ++i) {
    if (!yarns[i]) continue;
    for (DyedStretch& stretch : design.yarns[i].dye.stretches)
      if (stretch.color) seen.push_back(&*stretch.color);
  }
  return seen;
}

}  // namespace

Design with_swapped_lightness(Design design) {
  const std::vector<Rgb*> seen = seen_colors(design);
  std::vector<Rgb> order;
  for (const Rgb* color : seen)
    if (std::ranges::find(order, *color) == order.end()) order.push_back(*color);
  std::ranges::stable_sort(order, {}, [](Rgb color) { return oklab_of(color).lightness; });
  for (Rgb* color : seen) *color = *(order.rbegin() + (std::ranges::find(order, *color) - order.begin()));
  return design;
}

std::vector<Rgb> gradient(Rgb from, Rgb to, int steps) {
  const Oklab a = oklab_of(from), b = oklab_of(to);
  const int last = std::max(steps, 2) - 1;
  std::vector<Rgb> colors{from};
  for (int i = 1; i < last; ++i) {
    const float t = static_cast<float>(i) / static_cast<float>(last);
    colors.push_back(rgb_of({std::lerp(a.lightness, b.lightness, t), std::lerp(a.a, b.a, t), std::lerp(a.b, b.b, t)}));
  }
  colors.push_back(to);
  return colors;
}

Design with_gradient(Design design, System system, const std::vector<int>& threads, const Gradient& wanted) {
  if (threads.empty()) return design;
  const int steps = std::clamp(wanted.steps, 2, std::clamp(static_cast<int>(threads.size()), 2, kMaxColors));
  const std::vector<int> order = steps_of(threads.size(), steps, wanted.blended);
  std::vector<Rgb> palette = design.draft.palette;
  const std::vector<int> numbers = in_palette(palette, gradient(wanted.from, wanted.to, steps));
  if (numbers.empty()) return design;
  design.draft.palette = std::move(palette);
  std::vector<int>& colors = design.draft.threads(system).color;
  for (size_t i = 0; i < threads.size(); ++i)
    if (within(threads[i], colors.size()))
      colors[static_cast<size_t>(threads[i])] = numbers[static_cast<size_t>(order[i])];
  return design;
}

}  // namespace weftlight::design
