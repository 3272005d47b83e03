// Based on: weaving handbooks on double cloth. Each layer has its own ends and picks; a pick of the upper layer passes
// over all ends of the lower one, and vice versa. Crossings between two layers therefore vote for which layer is
// above; only stitches vote otherwise.

#include "cloth/layer_plan.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <string_view>

#include "analysis/weave_layers.h"
#include "cloth/centre_line.h"
#include "cloth/layers.h"
#include "cloth/thread_scene.h"
#include "design/repeat.h"

namespace weftlight::cloth {

using design::Repeat, design::structure_repeat;

namespace {

constexpr int kMaxLayers = 8;
constexpr int64_t kMaxCrossings = 1 << 22;  // larger cloths are drawn in one layer
constexpr int kMaxTiles = 64;               // tiles a side that are examined
constexpr float kMinTiles = 0.6f;           // fraction of the tiles that must be in layers
constexpr float kAlike = 0.74f;             // fraction of neighbouring tiles that must have the same layer above
constexpr int kMinPockets = 32;             // least threads in a repeat in which layers change places
constexpr float kMinWoven = 0.04f;          // least fraction of the rarer kind among a layer's own crossings
constexpr float kClear = 1.02f;             // margin over the measured heights of the layers
constexpr float kStitchHeld = 0.9f;         // of the sum of the radii: a stitch presses into the thread that it holds

// Orders in which ends and picks of two layers alternate. Orders of ends are also tried with the layers swapped.
constexpr std::array<std::string_view, 6> kEndOrders{"AB", "AABB", "ABBA", "AAB", "ABA", "BAA"};
constexpr std::array<std::string_view, 12> kPickOrders{"AB",  "BA",  "AABB", "ABBA", "BBAA", "BAAB",
                                                       "AAB", "ABA", "BAA",  "ABB",  "BAB",  "BBA"};

int side_of(std::string_view order) { return order.size() == 3 ? 6 : 4; }
bool fits(std::string_view order, int threads) {
  const int n = static_cast<int>(order.size());
  return threads >= side_of(order) && (threads % n == 0 || threads >= 24);
}

/// Bit mask of the threads of layer A within a tile.
unsigned bits_of(std::string_view order) {
  unsigned bits = 0;
  for (int i = 0; i < side_of(order); ++i)
    if (order[static_cast<size_t>(i) % order.size()] == 'A') bits |= 1u << i;
  return bits;
}

struct Tile {
  int ends = 0, picks = 0;
  std::array<unsigned, 6> rows{};
};

Tile tile_at(const BitMatrix& cells, int end, int pick, int ends, int picks) {
  Tile t{ends, picks, {}};
  for (int p = 0; p < picks; ++p)
    for (int e = 0; e < ends; ++e) t.rows[static_cast<size_t>(p)] |= (cells.get(pick + p, end + e) ? 1u : 0u) << e;
  return t;
}

/// Crossings between the layers, and those with A above. Within each layer: crossings, and those with the warp up.
struct Votes {
  int64_t all = 0, first = 0;
  std::array<int64_t, 2> own{}, own_up{};
};

Votes votes_of(const Tile& t, unsigned ends_a, unsigned picks_a) {
  const unsigned every = (1u << t.ends) - 1, ends_b = every & ~ends_a;
  Votes v;
  for (int p = 0; p < t.picks; ++p) {
    const unsigned row = t.rows[static_cast<size_t>(p)];
    const bool a = picks_a >> p & 1;
    const unsigned other = a ? ends_b : ends_a, same = a ? ends_a : ends_b;
    v.all += std::popcount(other);
    // An end of A over a pick of B; a pick of A over an end of B.
    v.first += a ? std::popcount(other & ~row) : std::popcount(other & row);
    v.own[a ? 0 : 1] += std::popcount(same), v.own_up[a ? 0 : 1] += std::popcount(same & row);
  }
  return v;
}

struct Orders {
  std::string_view ends, picks;
  float fraction = 0;  // of the tiles that are in layers
};

/// Fraction of the tiles in which at most one in eight crossings between such layers disagrees; 0 if these are no
/// layers.
float layered_fraction(const std::vector<Tile>& tiles, std::string_view ends, std::string_view picks) {
  const unsigned a = bits_of(ends), b = bits_of(picks);
  Votes sum;
  int64_t wrong = 0, layered = 0;
  for (const Tile& t : tiles) {
    const Votes v = votes_of(t, a, b);
    const int64_t against = std::min(v.first, v.all - v.first);
    if (8 * against <= v.all) ++layered;
    if (4 * against > v.all) continue;  // layers change places here, or there is a single cloth
    wrong += against;
    sum.all += v.all;
    for (size_t k = 0; k < 2; ++k) sum.own[k] += v.own[k], sum.own_up[k] += v.own_up[k];
  }
  if (layered == 0) return 0;
  // Each layer must be woven in itself, more often than the two are stitched; otherwise it is a weave backed with
  // extra ends or picks.
  const float stitched = static_cast<float>(wrong) / static_cast<float>(sum.all);
  for (size_t k = 0; k < 2; ++k) {
    const float woven = static_cast<float>(std::min(sum.own_up[k], sum.own[k] - sum.own_up[k])) /
                        static_cast<float>(std::max<int64_t>(sum.own[k], 1));
    if (woven < kMinWoven || woven < 2 * stitched) return 0;
  }
  return static_cast<float>(layered) / static_cast<float>(tiles.size());
}

std::vector<Tile> tiles_of(const BitMatrix& cells, int ends, int picks) {
  const int across = cells.cols() / ends, down = cells.rows() / picks;
  const int step_e = (across + kMaxTiles - 1) / kMaxTiles, step_p = (down + kMaxTiles - 1) / kMaxTiles;
  std::vector<Tile> tiles;
  for (int p = 0; p < down; p += step_p)
    for (int e = 0; e < across; e += step_e) tiles.push_back(tile_at(cells, e * ends, p * picks, ends, picks));
  return tiles;
}

Orders best_orders(const BitMatrix& cells) {
  Orders best;
  for (const int side_e : {4, 6}) {
    for (const int side_p : {4, 6}) {
      if (cells.cols() < side_e || cells.rows() < side_p) continue;
      const std::vector<Tile> tiles = tiles_of(cells, side_e, side_p);
      for (const std::string_view ends : kEndOrders) {
        if (side_of(ends) != side_e || !fits(ends, cells.cols())) continue;
        for (const std::string_view picks : kPickOrders) {
          if (side_of(picks) != side_p || !fits(picks, cells.rows())) continue;
          const float fraction = layered_fraction(tiles, ends, picks);
          if (fraction > best.fraction) best = {ends, picks, fraction};
        }
      }
    }
  }
  return best;
}

std::vector<uint8_t> layers_by(std::string_view order, int threads) {
  std::vector<uint8_t> out;
  for (int i = 0; i < threads; ++i) out.push_back(order[static_cast<size_t>(i) % order.size()] == 'A' ? 0 : 1);
  return out;
}

/// Groups of threads and the votes of their crossings.
struct Groups {
  int across = 0, down = 0;
  std::vector<int> all, first;  // crossings between layers; those with layer 0 above
  size_t at(int x, int y) const {
    return static_cast<size_t>((y + down) % down) * static_cast<size_t>(across) +
           static_cast<size_t>((x + across) % across);
  }
};

Groups groups_of(const BitMatrix& cells, const LayerPlan& plan) {
  Groups g{cells.cols() / plan.group_ends, cells.rows() / plan.group_picks, {}, {}};
  g.all.resize(static_cast<size_t>(g.across) * static_cast<size_t>(g.down));
  g.first.resize(g.all.size());
  for (int p = 0; p < cells.rows(); ++p) {
    for (int e = 0; e < cells.cols(); ++e) {
      const int a = plan.end_layer[static_cast<size_t>(e)], b = plan.pick_layer[static_cast<size_t>(p)];
      if (a == b) continue;
      const size_t i = g.at(std::min(e / plan.group_ends, g.across - 1), std::min(p / plan.group_picks, g.down - 1));
      ++g.all[i];
      g.first[i] += cells.get(p, e) == (a == 0);
    }
  }
  return g;
}

/// Layer above by agreeing blocks of groups, so that corners stay sharp; 0 where no block agrees.
std::vector<int8_t> decided_sides(const Groups& g, int wide, int high) {
  std::vector<int8_t> side(g.all.size());
  std::vector<float> by(g.all.size());
  for (int y = 0; y < g.down; ++y) {
    for (int x = 0; x < g.across; ++x) {
      int all = 0, first = 0;
      for (int j = 0; j < high; ++j)
        for (int i = 0; i < wide; ++i) all += g.all[g.at(x + i, y + j)], first += g.first[g.at(x + i, y + j)];
      const float sum = static_cast<float>(2 * first - all) / static_cast<float>(std::max(all, 1));
      if (std::abs(sum) < 0.7f) continue;
      for (int j = 0; j < high; ++j) {
        for (int i = 0; i < wide; ++i) {
          const size_t at = g.at(x + i, y + j);
          if (std::abs(sum) > by[at]) by[at] = std::abs(sum), side[at] = sum > 0 ? 1 : -1;
        }
      }
    }
  }
  return side;
}

/// Undecided groups take the side of the nearest decided one.
void spread(std::vector<int8_t>& side, const Groups& g) {
  std::vector<std::pair<int, int>> queue;
  for (int y = 0; y < g.down; ++y)
    for (int x = 0; x < g.across; ++x)
      if (side[g.at(x, y)] != 0) queue.emplace_back(x, y);
  for (size_t i = 0; i < queue.size(); ++i) {
    const auto [x, y] = queue[i];
    for (const auto& [dx, dy] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
      const int nx = (x + dx + g.across) % g.across, ny = (y + dy + g.down) % g.down;
      if (side[g.at(nx, ny)] != 0) continue;
      side[g.at(nx, ny)] = side[g.at(x, y)];
      queue.emplace_back(nx, ny);
    }
  }
}

/// Layer above in each tile: 1 or -1; 0 where its crossings do not agree.
std::vector<int> sides_of(const std::vector<Tile>& tiles, const Orders& orders) {
  const unsigned a = bits_of(orders.ends), b = bits_of(orders.picks);
  std::vector<int> sides;
  for (const Tile& t : tiles) {
    const Votes v = votes_of(t, a, b);
    sides.push_back(8 * std::min(v.first, v.all - v.first) > v.all ? 0 : 2 * v.first > v.all ? 1 : -1);
  }
  return sides;
}

/// Whether one layer lies above over large areas. Wide twills and shaded satins also look like layers that change
/// places, but every few threads.
bool in_areas(const BitMatrix& cells, const Orders& orders) {
  const int wide = side_of(orders.ends), high = side_of(orders.picks);
  const int across = cells.cols() / wide, down = cells.rows() / high;
  std::vector<Tile> tiles;
  for (int y = 0; y < down; ++y)
    for (int x = 0; x < across; ++x) tiles.push_back(tile_at(cells, x * wide, y * high, wide, high));
  if (tiles.size() < 4) return false;
  const std::vector<int> sides = sides_of(tiles, orders);
  const auto at = [&](int x, int y) { return sides[static_cast<size_t>(y % down * across + x % across)]; };
  const Repeat repeat = structure_repeat(cells);
  int alike = 0;
  bool wide_enough = true;
  for (int y = 0; y < down; ++y) {
    for (int x = 0; x < across; ++x) {
      alike += (at(x, y) != 0 && at(x, y) == at(x + 1, y)) + (at(x, y) != 0 && at(x, y) == at(x, y + 1));
      const bool along_weft = at(x, y) * at(x + 1, y) < 0, along_warp = at(x, y) * at(x, y + 1) < 0;
      wide_enough =
          wide_enough && (!along_weft || repeat.ends >= kMinPockets) && (!along_warp || repeat.picks >= kMinPockets);
    }
  }
  return wide_enough && static_cast<float>(alike) >= kAlike * 2 * static_cast<float>(tiles.size());
}

LayerPlan interleaved(const BitMatrix& cells) {
  const Orders orders = best_orders(cells);
  if (orders.fraction < kMinTiles || !in_areas(cells, orders)) return {};
  LayerPlan plan;
  plan.layers = 2;
  plan.end_layer = layers_by(orders.ends, cells.cols()), plan.pick_layer = layers_by(orders.picks, cells.rows());
  plan.group_ends = static_cast<int>(orders.ends.size()), plan.group_picks = static_cast<int>(orders.picks.size());
  const Groups g = groups_of(cells, plan);
  std::vector<int8_t> side = decided_sides(g, std::min(side_of(orders.ends) / plan.group_ends, g.across),
                                           std::min(side_of(orders.picks) / plan.group_picks, g.down));
  const auto found = std::ranges::count_if(side, [](int8_t s) { return s != 0; });
  if (static_cast<float>(found) < kMinTiles * static_cast<float>(side.size())) return {};
  spread(side, g);
  plan.groups = g.across;
  for (const int8_t s : side) plan.first_above.push_back(s > 0);
  return plan;
}

/// Layers that are not connected to each other; loose threads join the layer before them.
LayerPlan unconnected_layers(const BitMatrix& cells) {
  LayerPlan plan;
  plan.end_layer.resize(static_cast<size_t>(cells.cols())), plan.pick_layer.resize(static_cast<size_t>(cells.rows()));
  int layer = -1;
  for (const analysis::WeaveLayer& l : analysis::weave_layers(cells)) {
    if (!l.loose()) ++layer;
    const uint8_t at = static_cast<uint8_t>(std::clamp(layer, 0, 255));
    for (const int e : l.ends) plan.end_layer[static_cast<size_t>(e)] = at;
    for (const int p : l.picks) plan.pick_layer[static_cast<size_t>(p)] = at;
  }
  plan.layers = layer + 1;
  return plan;
}

BitMatrix ordered(const BitMatrix& cells, const std::vector<int>& ends, const std::vector<int>& picks) {
  BitMatrix out(cells.rows(), cells.cols());
  for (int p = 0; p < cells.rows(); ++p)
    for (int e = 0; e < cells.cols(); ++e)
      out.set(p, e, cells.get(picks[static_cast<size_t>(p)], ends[static_cast<size_t>(e)]));
  return out;
}

/// Largest distance of a layer's threads from its own middle plane.
float highest(const Cloth& one) {
  const CentreLines lines = centre_lines(one);
  float most = 0;
  for (const System system : {System::kWarp, System::kWeft}) {
    const bool warp = system == System::kWarp;
    const auto &threads = warp ? one.ends : one.picks, &crossed = warp ? one.picks : one.ends;
    for (size_t c = 0; c < crossed.size(); ++c) {
      CentreStep step = centre_step(one, system, crossed[c].centre_mm);
      for (const float t : {0.0f, 0.2f, 0.4f, 0.6f, 0.8f}) {
        step.t = t;
        for (size_t i = 0; i < threads.size(); ++i) {
          const CentrePoint p = centre_at(lines, system, static_cast<int>(i), step);
          most = std::max(most, std::abs(p.height_mm) + 0.5f * threads[i].height_mm * std::sqrt(1 + p.slope * p.slope));
        }
      }
    }
  }
  return most;
}

/// Levels at which layers touch, from their measured heights.
class Levels {
 public:
  Levels(const Cloth& cloth, const LayerPlan& plan) : plan_(plan) {
    for (int i = 0; i < layer_count(cloth); ++i) {
      half_.push_back(kClear * highest(one_layer(cloth, i)));
    }
  }
  /// Level of a layer at a crossing of the draft: below all layers above it and above all below it.
  float at(int layer, int end, int pick) const {
    float level = 0;
    for (int other = 0; other < static_cast<int>(half_.size()); ++other) {
      if (other == layer) continue;
      level += half_[static_cast<size_t>(other)] * (plan_.above(layer, other, end, pick) ? 1.0f : -1.0f);
    }
    return level;
  }

 private:
  const LayerPlan& plan_;
  std::vector<float> half_;  // height of each layer above its own middle
};

int nearest(const std::vector<ThreadBody>& threads, int first, int count, float mm) {
  const auto from = threads.begin() + first;
  const auto after =
      std::lower_bound(from, from + count, mm, [](const ThreadBody& t, float x) { return t.centre_mm < x; });
  const int i = static_cast<int>(after - from);
  if (i == count) return count - 1;
  return i > 0 && mm - from[i - 1].centre_mm < from[i].centre_mm - mm ? i - 1 : i;
}

}  // namespace

bool LayerPlan::above(int a, int b, int end, int pick) const {
  if (first_above.empty()) return a < b;
  const int rows = static_cast<int>(first_above.size()) / groups;
  const int x = std::min(end / group_ends, groups - 1), y = std::min(pick / group_picks, rows - 1);
  return first_above[static_cast<size_t>(y) * static_cast<size_t>(groups) + static_cast<size_t>(x)] == (a < b);
}

LayerPlan find_layers(const BitMatrix& cells) {
  // Two layers need at least four ends and four picks.
  if (cells.cols() < 4 || cells.rows() < 4 || int64_t{cells.cols()} * cells.rows() > kMaxCrossings) return {};
  LayerPlan plan = unconnected_layers(cells);
  if (plan.layers > 1 && plan.layers <= kMaxLayers) return plan;
  return interleaved(cells);
}

namespace {

/// Stitches: lifts ends over picks of another layer, or lowers them under, where the weave contradicts the order of
/// the layers.
void stitch(Cloth& cloth, const LayerPlan& plan, const Levels& levels, const std::vector<int>& end_order,
            const std::vector<int>& pick_order) {
  std::vector<CentreLines> lines;
  for (int i = 0; i < layer_count(cloth); ++i) {
    Cloth flat = one_layer(cloth, i);
    flat.warp_level_mm.clear(), flat.weft_level_mm.clear();
    lines.push_back(centre_lines(flat, {0, flat.up.cols(), 0, flat.up.rows()}));
  }
  for (int e = 0; e < cloth.up.cols(); ++e) {
    const int a = layer_of(cloth, System::kWarp, e), end = end_order[static_cast<size_t>(e)];
    const ClothLayer& own = cloth.layers[static_cast<size_t>(a)];
    for (int p = 0; p < cloth.up.rows(); ++p) {
      const int b = layer_of(cloth, System::kWeft, p), pick = pick_order[static_cast<size_t>(p)];
      const bool over = cloth.up.get(p, e);
      if (a == b || over == plan.above(a, b, end, pick)) continue;
      const ClothLayer& other = cloth.layers[static_cast<size_t>(b)];
      const ThreadBody &body = cloth.ends[static_cast<size_t>(e)], &held = cloth.picks[static_cast<size_t>(p)];
      const int k = nearest(cloth.picks, own.first_pick, own.picks, held.centre_mm);
      const int beside = nearest(cloth.ends, other.first_end, other.ends, body.centre_mm);
      const float pick_at =
          lines[static_cast<size_t>(b)].at(System::kWeft, beside, p - other.first_pick) + levels.at(b, end, pick);
      const float apart = kStitchHeld * 0.5f * (body.height_mm + held.height_mm) * (over ? 1.0f : -1.0f);
      const float base = lines[static_cast<size_t>(a)].at(System::kWarp, e - own.first_end, k);
      const size_t at =
          static_cast<size_t>(own.first_pick + k) * static_cast<size_t>(cloth.up.cols()) + static_cast<size_t>(e);
      cloth.warp_level_mm[at] = pick_at + apart - base;
    }
  }
}

}  // namespace

void put_in_layers(Cloth& cloth, const LayerPlan& plan, const std::vector<int>& end_order,
                   const std::vector<int>& pick_order) {
  const auto run_of = [](const std::vector<int>& order, const std::vector<uint8_t>& layer_of, int layer) {
    const auto is = [&](int thread) { return layer_of[static_cast<size_t>(thread)] == layer; };
    const auto first = std::ranges::find_if(order, is);
    return std::pair{static_cast<int>(first - order.begin()), static_cast<int>(std::ranges::count_if(order, is))};
  };
  for (int i = 0; i < plan.layers; ++i) {
    const auto [first_end, ends] = run_of(end_order, plan.end_layer, i);
    const auto [first_pick, picks] = run_of(pick_order, plan.pick_layer, i);
    cloth.layers.push_back({first_end, ends, first_pick, picks});
  }
  cloth.up = ordered(cloth.up, end_order, pick_order);
  const Levels levels(cloth, plan);
  cloth.warp_level_mm.assign(static_cast<size_t>(cloth.up.rows()) * static_cast<size_t>(cloth.up.cols()), 0.0f);
  for (int i = 0; i < plan.layers; ++i) {
    const ClothLayer& l = cloth.layers[static_cast<size_t>(i)];
    for (int p = l.first_pick; p < l.first_pick + l.picks; ++p)
      for (int e = l.first_end; e < l.first_end + l.ends; ++e)
        cloth.warp_level_mm[static_cast<size_t>(p) * static_cast<size_t>(cloth.up.cols()) + static_cast<size_t>(e)] =
            levels.at(i, end_order[static_cast<size_t>(e)], pick_order[static_cast<size_t>(p)]);
  }
  cloth.weft_level_mm = cloth.warp_level_mm;
  if (!plan.first_above.empty()) stitch(cloth, plan, levels, end_order, pick_order);
}

}  // namespace weftlight::cloth
