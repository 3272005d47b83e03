#include "design/edits.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>
#include <vector>

#include "design/loom.h"
#include "draft/factor.h"
#include "draft/skeleton.h"

namespace weftlight::design {

using draft::BitGrid, draft::BitMatrix, draft::Draft, draft::ShedControl, draft::Skeleton, draft::Threads,
    draft::blank_draft, draft::kFromYarn, draft::kMaxCells, draft::kMaxColors, draft::kMaxThreads, draft::lifts,
    draft::skeleton_tieup, draft::with_lifts;

namespace {

bool within(int index, int count) { return index >= 0 && index < count; }

bool is_length(float mm) { return mm == kFromYarn || (std::isfinite(mm) && mm >= 0); }

template <class T>
void set_all(std::vector<T>& table, std::span<const int> threads, T value) {
  for (const int thread : threads)
    if (within(thread, static_cast<int>(table.size()))) table[static_cast<size_t>(thread)] = value;
}

bool is_color(Rgb c) { return std::isfinite(c.r) && std::isfinite(c.g) && std::isfinite(c.b); }

Rgb in_gamut(Rgb c) { return {std::clamp(c.r, 0.0f, 1.0f), std::clamp(c.g, 0.0f, 1.0f), std::clamp(c.b, 0.0f, 1.0f)}; }

void set_mark(BitMatrix& grid, int row, int col, bool on, bool only) {
  if (on && only) std::fill(grid.row(row).begin(), grid.row(row).end(), 0);
  grid.set(row, col, on);
}

bool same_thread(const Threads& t, int a, int b) {
  return t.color[a] == t.color[b] && t.spacing_mm[a] == t.spacing_mm[b] && t.thickness_mm[a] == t.thickness_mm[b] &&
         t.yarn[a] == t.yarn[b];
}

// Smallest p such that each thread i equals thread i - p: n less the longest border (Knuth, Morris, Pratt 1977).
int stripe_period(const Threads& t) {
  const int n = t.size();
  std::vector<int> border(static_cast<size_t>(n) + 1, 0);
  for (int i = 1, k = 0; i < n; ++i) {
    while (k > 0 && !same_thread(t, i, k)) k = border[k];
    if (same_thread(t, i, k)) ++k;
    border[i + 1] = k;
  }
  return n - border[n];
}

// Resizes the table; new threads continue the stripes.
void resize_with_stripes(Threads& t, int n, int new_color) {
  const int old = t.size();
  const int period = old > 0 ? stripe_period(t) : 0;
  t.resize(n, new_color);
  for (int i = old; period > 0 && i < n; ++i) {
    t.color[i] = t.color[i - period];
    t.spacing_mm[i] = t.spacing_mm[i - period];
    t.thickness_mm[i] = t.thickness_mm[i - period];
    t.yarn[i] = t.yarn[i - period];
  }
}

bool single_treadled(const BitMatrix& treadling) {
  for (int p = 0; p < treadling.rows(); ++p)
    if (treadling.count(p) > 1) return false;
  return true;
}

}  // namespace

Design with_threading(Design design, int end, int shaft, bool on, bool only) {
  Draft& d = design.draft;
  if (!may_paint(design, BitGrid::kThreading)) return design;
  if (within(end, d.ends()) && within(shaft, d.shafts)) set_mark(d.threading, end, shaft, on, only);
  return design;
}

Design with_tieup(Design design, int treadle, int shaft, bool on) {
  Draft& d = design.draft;
  if (!may_paint(design, BitGrid::kTieup)) return design;
  if (within(treadle, d.treadles) && within(shaft, d.shafts)) d.tieup.set(treadle, shaft, on);
  return design;
}

Design with_treadling(Design design, int pick, int treadle, bool on, bool only) {
  Draft& d = design.draft;
  if (!may_paint(design, BitGrid::kTreadling)) return design;
  if (within(pick, d.picks()) && within(treadle, d.treadles)) set_mark(d.treadling, pick, treadle, on, only);
  return design;
}

Design with_liftplan(Design design, int pick, int shaft, bool on) {
  if (!within(pick, design.draft.picks()) || !within(shaft, design.draft.shafts)) return design;
  if (!may_paint(design, BitGrid::kLiftplan)) return design;
  design = to_liftplan(std::move(design));
  design.draft.liftplan.set(pick, shaft, on);
  return design;
}

Design with_thread_color(Design design, System system, int thread, int color) {
  return with_thread_color(std::move(design), system, std::span(&thread, 1), color);
}

Design with_thread_yarn(Design design, System system, int thread, int yarn) {
  return with_thread_yarn(std::move(design), system, std::span(&thread, 1), yarn);
}

Design with_thread_thickness(Design design, System system, int thread, float mm) {
  return with_thread_thickness(std::move(design), system, std::span(&thread, 1), mm);
}

Design with_thread_spacing(Design design, System system, int thread, float mm) {
  return with_thread_spacing(std::move(design), system, std::span(&thread, 1), mm);
}

Design with_thread_color(Design design, System system, std::span<const int> threads, int color) {
  if (within(color, static_cast<int>(design.draft.palette.size())))
    set_all(design.draft.threads(system).color, threads, color);
  return design;
}

Design with_thread_yarn(Design design, System system, std::span<const int> threads, int yarn) {
  if (within(yarn, static_cast<int>(design.yarns.size()))) set_all(design.draft.threads(system).yarn, threads, yarn);
  return design;
}

Design with_thread_thickness(Design design, System system, std::span<const int> threads, float mm) {
  if (is_length(mm)) set_all(design.draft.threads(system).thickness_mm, threads, mm);
  return design;
}

Design with_thread_spacing(Design design, System system, std::span<const int> threads, float mm) {
  if (is_length(mm)) set_all(design.draft.threads(system).spacing_mm, threads, mm);
  return design;
}

Design with_palette_color(Design design, int color, Rgb rgb) {
  auto& palette = design.draft.palette;
  if (within(color, static_cast<int>(palette.size())) && is_color(rgb)) palette[color] = in_gamut(rgb);
  return design;
}

Design with_new_palette_color(Design design, Rgb rgb) {
  auto& palette = design.draft.palette;
  if (palette.size() < static_cast<size_t>(kMaxColors) && is_color(rgb)) palette.push_back(in_gamut(rgb));
  return design;
}

Design with_yarn(Design design, int yarn, const Yarn& value) {
  if (!within(yarn, static_cast<int>(design.yarns.size()))) return design;
  const std::string before = std::exchange(design.yarns[yarn], clamped(value)).name;
  const std::string& name = design.yarns[yarn].name;
  const bool of_others = std::ranges::count(design.yarns, before, &Yarn::name) > 0;
  YarnPurchase bought = purchase_of(design.plan, before);
  if (before == name || of_others || bought == YarnPurchase{before}) return design;
  design.plan = with_purchase(std::move(design.plan), {before, 0, 0, 0});
  bought.yarn = name;
  design.plan = with_purchase(std::move(design.plan), std::move(bought));
  return design;
}

Design with_new_yarn(Design design, const Yarn& value) {
  if (design.yarns.size() < static_cast<size_t>(kMaxColors)) design.yarns.push_back(clamped(value));
  return design;
}

Design with_size(Design design, int ends, int picks, int shafts, int treadles) {
  ends = std::clamp(ends, 1, kMaxThreads);
  picks = std::clamp(picks, 1, kMaxThreads);
  shafts = std::clamp(shafts, 1, kMaxShafts);
  treadles = std::clamp(treadles, 1, kMaxShafts);
  if (int64_t{ends} * picks > kMaxCells) return design;
  Draft& d = design.draft;
  if (d.palette.empty()) d.palette = blank_draft(1, 1, 1, 1).palette;
  d.shafts = shafts;
  d.treadles = treadles;
  d.threading.resize(ends, shafts);
  d.tieup.resize(treadles, shafts);
  d.treadling.resize(picks, treadles);
  d.liftplan.resize(picks, shafts);
  resize_with_stripes(d.warp, ends, 0);
  resize_with_stripes(d.weft, picks, static_cast<int>(d.palette.size()) > 1 ? 1 : 0);
  return design;
}

SizeLoss lost_by_size(const Draft& d, int ends, int picks, int shafts, int treadles) {
  const auto rows_beyond = [](const BitMatrix& m, int rows, int columns) {
    BitMatrix kept = m;
    kept.resize(m.rows(), columns);
    int lost = 0;
    for (int row = 0; row < std::min(rows, m.rows()); ++row) lost += kept.count(row) < m.count(row) ? 1 : 0;
    return lost;
  };
  SizeLoss loss;
  loss.ends = rows_beyond(d.threading, ends, shafts);
  if (d.shed_control == ShedControl::kLiftplan) {
    loss.picks = rows_beyond(d.liftplan, picks, shafts);
    return loss;
  }
  loss.picks = rows_beyond(d.treadling, picks, treadles);
  BitMatrix kept = d.tieup;
  kept.resize(treadles, shafts);
  loss.tieup = d.tieup.count() - kept.count();
  return loss;
}

Design with_plan(Design design, ClothPlan plan) {
  design.plan = clamped(std::move(plan));
  return design;
}

Design with_sett(Design design, System system, double per_cm) {
  std::vector<float>& spacing = design.draft.threads(system).spacing_mm;
  double sum = 0;
  for (size_t i = 0; i < spacing.size(); ++i) sum += spacing_of(design, system, static_cast<int>(i));
  const double scale = 10.0 * static_cast<double>(spacing.size()) / (per_cm * sum);
  if (!(std::isfinite(scale) && scale > 0)) return design;
  for (size_t i = 0; i < spacing.size(); ++i)
    spacing[i] = static_cast<float>(scale * spacing_of(design, system, static_cast<int>(i)));
  return design;
}

Design with_rising(Design design, bool rising) {
  design.draft.rising = rising;
  return design;
}

Design to_liftplan(Design design) {
  design.draft.liftplan = lifts(design.draft);
  design.draft.shed_control = ShedControl::kLiftplan;
  return design;
}

Design to_treadling(Design design, int most_treadles) {
  Draft& d = design.draft;
  if (d.shed_control == ShedControl::kTreadling && single_treadled(d.treadling)) return design;
  const BitMatrix lift = lifts(d);
  Draft base = d;
  base.shed_control = ShedControl::kTreadling;
  for (int p = 0; p < d.picks(); ++p)
    if (base.treadling.count(p) > 1) std::ranges::fill(base.treadling.row(p), 0);
  if (base.treadling.count() == 0) {
    base.treadles = 0;
    base.tieup = BitMatrix(0, d.shafts);
    base.treadling = BitMatrix(d.picks(), 0);
  }
  base::Result<Draft> factored = with_lifts(base, lift, std::max(most_treadles, base.treadles));
  if (!factored) return design;
  d = std::move(*factored);
  if (d.treadles == 0) {
    d.treadles = 1;
    d.tieup.resize(1, d.shafts);
    d.treadling.resize(d.picks(), 1);
  }
  if (design.loom.leading == Leading::kLiftplan) design.loom.leading = Leading::kThreading;
  return design;
}

Design to_skeleton(Design design, int treadles_per_pick, const base::TaskProgress& progress) {
  Draft& d = design.draft;
  Skeleton skeleton = skeleton_tieup(lifts(d), treadles_per_pick, progress);
  if (skeleton.tieup.rows() < 1 || skeleton.tieup.rows() > kMaxShafts) return design;
  d.treadles = skeleton.tieup.rows();
  d.tieup = std::move(skeleton.tieup);
  d.treadling = std::move(skeleton.treadling);
  d.shed_control = ShedControl::kTreadling;
  if (design.loom.leading == Leading::kLiftplan) design.loom.leading = Leading::kThreading;
  return design;
}

Design with_leading(Design design, Leading leading) {
  if (leading == Leading::kLiftplan) design = to_liftplan(std::move(design));
  design.loom.leading = leading;
  return design;
}

Design with_lock(Design design, bool locked) {
  design.loom.locked = locked;
  return design;
}

}  // namespace weftlight::design
