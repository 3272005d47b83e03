// Simple weaves, and functions shared by all generators.
//
// Sett. Based on: T. R. Ashenhurst, A Treatise on Textile Calculations and the Structure of Fabrics, 1884:
// a thread needs room for itself and for the threads that pass between it and the next, so that fewer interlacings
// allow a closer sett. Differs: Ashenhurst counts round threads on
// the loom. Finished cloth is closer, its threads flattened and bloomed until they nearly touch: they cover about 6/7
// of the width in plain weave and, where no thread passes between them, all of it (F. T. Peirce, The Geometry
// of Cloth Structure, 1937, on flattened threads and cover).

#include "draft/generators.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "draft/drawdown.h"

namespace weftlight::draft {
namespace {

constexpr float kGapAtPlain = 1.0f / 7.0f;  // fraction of the width that is open in plain weave

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

// Interlacings per crossing along the rows, 0..1.
float interlacing(const BitMatrix& cells) {
  int64_t changes = 0;
  for (int r = 0; r < cells.rows(); ++r) {
    for (int c = 0; c < cells.cols(); ++c) changes += cells.get(r, c) != cells.get(r, (c + 1) % cells.cols());
  }
  const float crossings = static_cast<float>(cells.rows()) * static_cast<float>(cells.cols());
  return crossings > 0 ? static_cast<float>(changes) / crossings : 0;
}

float mean_width_mm(const Threads& threads, const std::vector<Yarn>& yarns) {
  float sum = 0;
  for (int i = 0; i < threads.size(); ++i) {
    const Yarn& yarn = yarns[threads.yarn[i]];
    const float own = threads.thickness_mm[i];
    // Width of an ellipse with the area of the round thread; `flattening` is its height over its width.
    sum += (own >= 0 ? own : yarn.diameter_mm) / std::sqrt(yarn.flattening);
  }
  return threads.size() > 0 ? sum / static_cast<float>(threads.size()) : 0;
}

void set_spacing(Threads& threads, const std::vector<Yarn>& yarns, float interlacings, float openness) {
  const float mm = mean_width_mm(threads, yarns) / (1 - kGapAtPlain * interlacings) * openness;
  // Rounded to 0.01 mm, as the user reads the number.
  std::fill(threads.spacing_mm.begin(), threads.spacing_mm.end(), std::round(mm * 100) / 100);
}

void set_stripes(Threads& threads, const std::vector<Stripe>& order, size_t colors) {
  std::vector<int> sequence;
  for (const Stripe& stripe : order) {
    const int color = std::clamp(stripe.color, 0, static_cast<int>(colors) - 1);
    sequence.insert(sequence.end(), static_cast<size_t>(std::clamp(stripe.threads, 0, kMaxThreads)), color);
  }
  if (sequence.empty()) return;
  for (size_t i = 0; i < threads.color.size(); ++i) threads.color[i] = sequence[i % sequence.size()];
}

const std::vector<Rgb> kDefaultPalette = {{0.15f, 0.16f, 0.20f}, {0.93f, 0.91f, 0.86f}};

}  // namespace

Design make_design(const Recipe& recipe, ClothSize size) {
  const int treadles = static_cast<int>(recipe.tieup.size());
  Design design;
  design.draft = blank_draft(std::clamp(size.ends, 1, kMaxThreads), std::clamp(size.picks, 1, kMaxThreads),
                             recipe.shafts, treadles);
  Draft& d = design.draft;
  for (int e = 0; e < d.ends(); ++e) d.threading.set(e, recipe.threading[e % recipe.threading.size()], true);
  for (int p = 0; p < d.picks(); ++p) d.treadling.set(p, recipe.treadling[p % recipe.treadling.size()], true);
  for (int t = 0; t < treadles; ++t) {
    for (const int shaft : recipe.tieup[t]) d.tieup.set(t, shaft, true);
  }
  d.palette = kDefaultPalette;
  return with_sett(std::move(design));
}

Design plain(ClothSize size) { return make_design({2, {0, 1}, {{0}, {1}}, {0, 1}}, size); }

Design basket(int group, ClothSize size) {
  std::vector<int> order(static_cast<size_t>(std::clamp(group, 1, kMaxThreads)), 0);
  order.resize(order.size() * 2, 1);
  return make_design({2, order, {{0}, {1}}, order}, size);
}

Design twill(const OverUnder& order, Lean lean, ClothSize size) {
  const auto tieup = twill_tieup(order, lean);
  const int n = static_cast<int>(tieup.size());
  return make_design({n, straight(n), tieup, straight(n)}, size);
}

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
    const double wave = 0.5 - 0.5 * std::cos(2 * std::numbers::pi * i / steps);
    draw.insert(draw.end(), static_cast<size_t>(1 + std::lround(amplitude * wave)), i % n);
  }
  if (!diamonds) return make_design({n, draw, tieup, straight(n)}, size);
  draw = mirrored(std::move(draw));
  return make_design({n, draw, tieup, draw}, size);
}

Design with_colors(Design design, std::vector<Rgb> palette, const std::vector<Stripe>& warp,
                   const std::vector<Stripe>& weft) {
  Draft& d = design.draft;
  if (palette.empty()) return design;
  d.palette = std::move(palette);
  const int last = static_cast<int>(d.palette.size()) - 1;
  for (Threads* threads : {&d.warp, &d.weft}) {
    for (int& color : threads->color) color = std::min(color, last);
  }
  set_stripes(d.warp, warp, d.palette.size());
  set_stripes(d.weft, weft, d.palette.size());
  return design;
}

Design with_sett(Design design, float openness) {
  const BitMatrix cells = drawdown(design.draft);
  set_spacing(design.draft.warp, design.yarns, interlacing(cells), openness);
  set_spacing(design.draft.weft, design.yarns, interlacing(transposed(cells)), openness);
  return design;
}

}  // namespace weftlight::draft
