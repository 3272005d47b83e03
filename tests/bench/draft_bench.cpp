// Speed of drawdowns and of results computed from them.

#include <benchmark/benchmark.h>

#include <cstring>
#include <random>

#include "analysis/floats.h"
#include "analysis/weave_layers.h"
#include "design/crossings.h"
#include "design/edits.h"
#include "design/repeat.h"
#include "draft/drawdown.h"
#include "draft/factor.h"
#include "weaves/weaves.h"

namespace {

using weftlight::analysis::crossings_in_floats, weftlight::analysis::long_floats, weftlight::analysis::longest_floats,
    weftlight::analysis::weave_layers;
using weftlight::design::Design, weftlight::design::Leading, weftlight::design::painted_cell,
    weftlight::design::structure_repeat, weftlight::design::with_liftplan, weftlight::design::with_threading,
    weftlight::design::with_tieup, weftlight::design::with_treadling;
using weftlight::draft::BitMatrix, weftlight::draft::Draft, weftlight::draft::Face, weftlight::draft::ShedControl,
    weftlight::draft::drawdown, weftlight::draft::update_drawdown, weftlight::draft::with_drawdown;
using weftlight::weaves::Lean, weftlight::weaves::twill;

constexpr int kLarge = 10000;
constexpr int kShafts = 32;

Draft large_draft(ShedControl shed_control) {
  std::mt19937 random(1);
  Draft d = twill({3, 2, 1, 2, 5, 3, 4, 3, 2, 3, 1, 3}, Lean::kRight, {kLarge, kLarge}).draft;
  for (int p = 0; p < d.picks(); ++p) {
    for (int s = 0; s < d.shafts; ++s) d.liftplan.set(p, s, random() % 2 == 0);
  }
  d.shed_control = shed_control;
  return d;
}

void copy_of_drawdown(benchmark::State& state) {
  const BitMatrix cells = drawdown(large_draft(ShedControl::kTreadling));
  BitMatrix to = cells;
  for (auto _ : state) {
    for (int r = 0; r < cells.rows(); ++r)
      std::memcpy(to.row(r).data(), cells.row(r).data(), cells.row(r).size_bytes());
    benchmark::DoNotOptimize(to.row(0).data());
    benchmark::ClobberMemory();
  }
  state.SetBytesProcessed(state.iterations() * cells.rows() * cells.words() * 8);
}
BENCHMARK(copy_of_drawdown)->Unit(benchmark::kMillisecond);

void drawdown_10000_treadled(benchmark::State& state) {
  const Draft d = large_draft(ShedControl::kTreadling);
  if (d.shafts != kShafts) state.SkipWithError("the draft should have 32 shafts");
  for (auto _ : state) benchmark::DoNotOptimize(drawdown(d));
}
BENCHMARK(drawdown_10000_treadled)->Unit(benchmark::kMillisecond);

void drawdown_10000_random_liftplan(benchmark::State& state) {
  const Draft d = large_draft(ShedControl::kLiftplan);
  for (auto _ : state) benchmark::DoNotOptimize(drawdown(d));
}
BENCHMARK(drawdown_10000_random_liftplan)->Unit(benchmark::kMillisecond);

// One painted cell of a Jacquard-sized draft, set and cleared.
enum class Cell { kThreading, kTieup, kTreadling, kLiftplan };

void update_1285_x_3058(benchmark::State& state) {
  const Design before = twill({3, 2, 1, 2, 5, 3, 4, 3, 2, 3, 1, 3}, Lean::kRight, {1285, 3058});
  Design after = before;
  switch (static_cast<Cell>(state.range(0))) {
    case Cell::kThreading:
      after = with_threading(before, 640, 5, true);
      break;
    case Cell::kTieup:
      after = with_tieup(before, 3, 5, !before.draft.tieup.get(3, 5));
      break;
    case Cell::kTreadling:
      after = with_treadling(before, 1500, 7, true);
      break;
    case Cell::kLiftplan:
      after = with_liftplan(before, 1500, 7, true);
      break;
  }
  BitMatrix cells = drawdown(before.draft);
  for (auto _ : state) {
    benchmark::DoNotOptimize(update_drawdown(cells, before.draft, after.draft));
    benchmark::DoNotOptimize(update_drawdown(cells, after.draft, before.draft));
  }
}
BENCHMARK(update_1285_x_3058)->DenseRange(0, 3)->Unit(benchmark::kMicrosecond);

void edit_and_commit_copy_1285_x_3058(benchmark::State& state) {
  const Design design = twill({3, 2, 1, 2, 5, 3, 4, 3}, Lean::kRight, {1285, 3058});
  for (auto _ : state) benchmark::DoNotOptimize(with_threading(design, 640, 5, true));
}
BENCHMARK(edit_and_commit_copy_1285_x_3058)->Unit(benchmark::kMicrosecond);

void floats_10000(benchmark::State& state) {
  const BitMatrix cells = drawdown(large_draft(ShedControl::kLiftplan));
  for (auto _ : state) benchmark::DoNotOptimize(longest_floats(cells));
}
BENCHMARK(floats_10000)->Unit(benchmark::kMillisecond);

void repeat_10000(benchmark::State& state) {
  const BitMatrix cells = drawdown(large_draft(ShedControl::kTreadling));
  for (auto _ : state) benchmark::DoNotOptimize(structure_repeat(cells));
}
BENCHMARK(repeat_10000)->Unit(benchmark::kMillisecond);

void long_floats_10000(benchmark::State& state) {
  const BitMatrix cells = drawdown(large_draft(ShedControl::kTreadling));
  for (auto _ : state) benchmark::DoNotOptimize(long_floats(cells, 4));
}
BENCHMARK(long_floats_10000)->Unit(benchmark::kMillisecond);

void float_overlay_10000(benchmark::State& state) {
  const BitMatrix cells = drawdown(large_draft(ShedControl::kTreadling));
  for (auto _ : state) benchmark::DoNotOptimize(crossings_in_floats(cells, 4, Face::kFront));
}
BENCHMARK(float_overlay_10000)->Unit(benchmark::kMillisecond);

void layers_10000(benchmark::State& state) {
  const BitMatrix cells = drawdown(large_draft(ShedControl::kTreadling));
  for (auto _ : state) benchmark::DoNotOptimize(weave_layers(cells));
}
BENCHMARK(layers_10000)->Unit(benchmark::kMillisecond);

void factor_a_painted_cell_1285_x_3058(benchmark::State& state) {
  const Draft d = twill({3, 2, 1, 2, 5, 3, 4, 3}, Lean::kRight, {1285, 3058}).draft;
  BitMatrix cells = drawdown(d);
  cells.set(100, 100, !cells.get(100, 100));
  for (auto _ : state) benchmark::DoNotOptimize(with_drawdown(d, cells, {}));
}
BENCHMARK(factor_a_painted_cell_1285_x_3058)->Unit(benchmark::kMillisecond);

// A crossing painted while the drawdown leads, and the drawdown that is shown.
void paint_a_crossing(benchmark::State& state) {
  const int size = static_cast<int>(state.range(0));
  Design design = twill({3, 2, 1, 2, 5, 3, 4, 3}, Lean::kRight, {size, size});
  design.loom.leading = Leading::kDrawdown;
  BitMatrix cells = drawdown(design.draft);
  const bool up = !cells.get(size / 2, size / 3);
  for (auto _ : state) {
    const Design painted = *painted_cell(design, size / 3, size / 2, up);
    benchmark::DoNotOptimize(update_drawdown(cells, design.draft, painted.draft));
    benchmark::DoNotOptimize(update_drawdown(cells, painted.draft, design.draft));
  }
}
BENCHMARK(paint_a_crossing)->Arg(2000)->Arg(10000)->Unit(benchmark::kMillisecond);

}  // namespace
