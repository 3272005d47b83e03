// Plain weave, basket, twills and satins.
// The corkscrew is based on: Z. Grosicki, Watson's Textile Design and Colour, 7th edition, 1975.

#include <algorithm>
#include <numeric>

#include "weaves/families.h"
#include "weaves/weaves.h"

namespace weftlight::weaves {

using design::Design;
using draft::Face, draft::kMaxShafts, draft::kMaxThreads;

namespace {

int wrapped(int i, int n) { return ((i % n) + n) % n; }

// For each shaft of a straight draw, whether it is up on the first pick.
std::vector<char> lifts_of_first_pick(const OverUnder& order) {
  std::vector<char> up;
  bool over = true;
  for (const int threads : order) {
    const int room = kMaxShafts - static_cast<int>(up.size());
    up.insert(up.end(), static_cast<size_t>(std::clamp(threads, 0, room)), over ? 1 : 0);
    over = !over;
  }
  if (up.empty()) up = {1, 0};
  return up;
}

std::vector<std::vector<int>> twill_tieup(const OverUnder& order, Lean lean) {
  const std::vector<char> up = lifts_of_first_pick(order);
  const int n = static_cast<int>(up.size());
  std::vector<std::vector<int>> tieup(up.size());
  for (int t = 0; t < n; ++t) {
    for (int s = 0; s < n; ++s) {
      if (up[wrapped(lean == Lean::kRight ? s - t : s + t, n)]) tieup[t].push_back(s);
    }
  }
  return tieup;
}

std::vector<int> straight(int n) {
  std::vector<int> order(static_cast<size_t>(n));
  std::iota(order.begin(), order.end(), 0);
  return order;
}

// Forwards and backwards, without repeating the first and the last.
std::vector<int> mirrored(std::vector<int> order) {
  for (int i = static_cast<int>(order.size()) - 2; i > 0; --i) order.push_back(order[i]);
  return order;
}

std::vector<int> point(int n) { return mirrored(straight(n)); }

}  // namespace

Design plain(ClothSize size) { return make_design({2, {0, 1}, {{0}, {1}}, {0, 1}}, size); }

Design basket(int group, ClothSize size) {
  std::vector<int> order(static_cast<size_t>(std::clamp(group, 1, kMaxThreads)), 0);
  order.resize(order.size() * 2, 1);
  return make_design({2, order, {{0}, {1}}, order}, size);
}

Recipe twill_recipe(const OverUnder& order, Lean lean) {
  const auto tieup = twill_tieup(order, lean);
  const int n = static_cast<int>(tieup.size());
  return {n, straight(n), tieup, straight(n)};
}

Design twill(const OverUnder& order, Lean lean, ClothSize size) { return make_design(twill_recipe(order, lean), size); }

Design satin(int shafts, int step, Face face, ClothSize size) {
  const int n = std::clamp(shafts, 2, kMaxShafts);
  int s = std::clamp(step, 1, n - 1);
  while (s > 1 && std::gcd(s, n) != 1) --s;
  std::vector<std::vector<int>> tieup(static_cast<size_t>(n));
  for (int t = 0; t < n; ++t) {
    const int bound = static_cast<int>(int64_t{t} * s % n);
    for (int shaft = 0; shaft < n; ++shaft) {
      if ((shaft == bound) == (face == Face::kBack)) tieup[t].push_back(shaft);
    }
  }
  return make_design({n, straight(n), tieup, straight(n)}, size);
}

Design pointed_twill(const OverUnder& order, bool diamonds, ClothSize size) {
  const auto tieup = twill_tieup(order, Lean::kRight);
  const int n = static_cast<int>(tieup.size());
  return make_design({n, point(n), tieup, diamonds ? point(n) : straight(n)}, size);
}

Design herringbone(const OverUnder& order, int band, ClothSize size) {
  const auto tieup = twill_tieup(order, Lean::kRight);
  const int n = static_cast<int>(tieup.size());
  // Each turn skips half the shafts, so that the two neighbours across it weave opposite.
  std::vector<int> threading;
  int shaft = 0;
  const int ends = std::clamp(band, 1, kMaxThreads);
  for (int i = 0; i < ends; ++i) threading.push_back(wrapped(shaft++, n));
  shaft = shaft - 1 + n / 2;
  for (int i = 0; i < ends; ++i) threading.push_back(wrapped(shaft--, n));
  return make_design({n, threading, tieup, straight(n)}, size);
}

Design corkscrew(int shafts, Face face, Lean lean, ClothSize size) {
  const int n = std::clamp(shafts, 3, kMaxShafts - 1) | 1, over = (n + 1) / 2;
  Recipe recipe{n, straight(n), {}, straight(n)};
  for (int t = 0; t < n; ++t) {
    recipe.tieup.emplace_back();
    for (int s = 0; s < n; ++s)
      if (wrapped((lean == Lean::kRight ? t : -t) - s * over, n) < over) recipe.tieup.back().push_back(s);
  }
  return make_design(face == Face::kBack ? turned(recipe) : recipe, size);
}

Design advancing_twill(const OverUnder& order, int run, int advance, ClothSize size) {
  const auto tieup = twill_tieup(order, Lean::kRight);
  const int n = static_cast<int>(tieup.size());
  std::vector<int> draw;
  for (int start = 0; start < n; ++start) {
    for (int i = 0; i < std::clamp(run, 1, n); ++i) draw.push_back(wrapped(start * advance + i, n));
  }
  return make_design({n, draw, tieup, draw}, size);
}

Design undulating_twill(const OverUnder& order, int widest, bool diamonds, ClothSize size) {
  const auto tieup = twill_tieup(order, Lean::kRight);
  const int n = static_cast<int>(tieup.size());
  const int steps = 3 * n;  // one wave goes three times through the shafts
  const double amplitude = std::clamp(widest, 1, 8) - 1;
  std::vector<int> draw;
  for (int i = 0; i < steps; ++i) {
    const double way = static_cast<double>(i) / steps;
    draw.insert(draw.end(), static_cast<size_t>(1 + wave_at(way, amplitude)), i % n);
  }
  if (!diamonds) return make_design({n, draw, tieup, straight(n)}, size);
  draw = mirrored(std::move(draw));
  return make_design({n, draw, tieup, draw}, size);
}

}  // namespace weftlight::weaves
