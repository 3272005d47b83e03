// Speed of the stages between an edit and the graphics card, as in the worker of the window: drawdown, layout, maps of
// both faces, threads and the far-field BRDF.

#include <benchmark/benchmark.h>

#include <functional>
#include <memory>
#include <random>

#include "design/edits.h"
#include "files/files.h"
#include "render_data/stages.h"
#include "weaves/weaves.h"

namespace {

using weftlight::design::Design, weftlight::design::to_liftplan;
using weftlight::draft::BitMatrix, weftlight::draft::Draft, weftlight::draft::ShedControl;
using weftlight::render_data::Effort;
using weftlight::render_data::Stages;
using weftlight::weaves::Lean, weftlight::weaves::twill;

constexpr int kLarge = 10000;

std::shared_ptr<const Design> kept(Design design) {
  design.scene.mesh.clear();
  return std::make_shared<const Design>(std::move(design));
}

/// 32 shafts with random picks, so that nothing repeats.
Design large_design(int ends, int picks, ShedControl shed_control) {
  std::mt19937 random(1);
  Design design = twill({3, 2, 1, 2, 5, 3, 4, 3, 2, 3, 1, 3}, Lean::kRight, {ends, picks});
  Draft& d = design.draft;
  if (shed_control == ShedControl::kLiftplan) {
    d = to_liftplan(design).draft;
    for (int p = 0; p < d.picks(); ++p)
      for (int s = 0; s < d.shafts; ++s) d.liftplan.set(p, s, random() % 2 == 0);
  } else {
    for (int p = 0; p < d.picks(); ++p) {
      for (int t = 0; t < d.treadles; ++t) d.treadling.set(p, t, false);
      d.treadling.set(p, static_cast<int>(random() % 32), true);
    }
  }
  return design;
}

/// A new draft until its first, or its final, picture can be drawn.
void cloth_from(benchmark::State& state, const Design& design, Effort effort) {
  const auto shown = kept(design);
  for (auto _ : state) {
    Stages stages;
    benchmark::DoNotOptimize(stages.update(shown, effort).all_maps);
  }
}

/// An edit of a completely visible cloth, and its reversal.
void edited(benchmark::State& state, const Design& design, const std::function<void(Draft&)>& edit, Effort effort) {
  Stages stages;
  Design next = design;
  stages.update(kept(design));
  // Completely visible, 2.5 threads per pixel.
  stages.set_visible_part({0, 0, 1e6f, 1e6f, 1.2f});
  for (auto _ : state) {
    edit(next.draft);
    const auto shown = kept(next);
    benchmark::DoNotOptimize(stages.update(shown, effort).all_maps);
  }
}

void flip(BitMatrix& bits, int row, int col) { bits.set(row, col, !bits.get(row, col)); }

void first_cloth_of_starter(benchmark::State& state) {
  const Design starter = twill({2, 2}, Lean::kRight, {96, 96});
  cloth_from(state, starter, Effort::kQuick);
}
void first_cloth_1285_x_3058(benchmark::State& state) {
  cloth_from(state, large_design(1285, 3058, ShedControl::kTreadling), Effort::kQuick);
}
void first_cloth_10000_treadled(benchmark::State& state) {
  cloth_from(state, large_design(kLarge, kLarge, ShedControl::kTreadling), Effort::kQuick);
}
void first_cloth_10000_random_liftplan(benchmark::State& state) {
  cloth_from(state, large_design(kLarge, kLarge, ShedControl::kLiftplan), Effort::kQuick);
}
void whole_cloth_10000_random_liftplan(benchmark::State& state) {
  cloth_from(state, large_design(kLarge, kLarge, ShedControl::kLiftplan), Effort::kFull);
}
void cloth_after_a_tieup_cell_1285_x_3058(benchmark::State& state) {
  edited(
      state, large_design(1285, 3058, ShedControl::kTreadling), [](Draft& d) { flip(d.tieup, 3, 5); }, Effort::kQuick);
}

BENCHMARK(first_cloth_of_starter)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();
BENCHMARK(first_cloth_1285_x_3058)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();
BENCHMARK(first_cloth_10000_treadled)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();
BENCHMARK(first_cloth_10000_random_liftplan)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();
BENCHMARK(whole_cloth_10000_random_liftplan)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();
BENCHMARK(cloth_after_a_tieup_cell_1285_x_3058)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();

}  // namespace
