// Costs from section 4 of the paper (colour texture below 1 s, shadow map 0.5 s), and the cost of an edit.

#include <benchmark/benchmark.h>

#include <functional>

#include "cloth/maps.h"
#include "design/edits.h"

namespace weftlight::cloth {

using design::Design, design::to_liftplan;
using draft::BitMatrix, draft::Draft, draft::Face, draft::blank_draft, draft::drawdown, draft::update_drawdown;

namespace {

/// A straight draft on 8 shafts, satin of step 5, with the default spacing of the yarn.
Design satin_design(int ends, int picks) {
  Design d;
  d.draft = blank_draft(ends, picks, 8, 8);
  for (int e = 0; e < ends; ++e) d.draft.threading.set(e, e % 8, true);
  for (int p = 0; p < picks; ++p) d.draft.treadling.set(p, p % 8, true);
  for (int t = 0; t < 8; ++t)
    for (int s = 0; s < 8; ++s) d.draft.tieup.set(t, s, s * 5 % 8 != t);
  return d;
}

Cloth laid_out(const Design& d) { return lay_out(d, drawdown(d.draft), Face::kFront, Period::kWholeDraft); }

void BM_BakeAllMaps(benchmark::State& state) {
  const Cloth cloth = laid_out(satin_design(8, 8));
  const int n = static_cast<int>(state.range(0));
  for (auto _ : state) benchmark::DoNotOptimize(bake(cloth, {n, n, static_cast<int>(state.range(1)), 0}));
  state.SetItemsProcessed(state.iterations() * n * n);
}
BENCHMARK(BM_BakeAllMaps)
    ->Args({1024, 16})
    ->Args({1024, 0})
    ->Args({2048, 16})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

void BM_ShadowMap(benchmark::State& state) {
  const Maps maps = bake(laid_out(satin_design(8, 8)), {1024, 1024, 0, 0});
  for (auto _ : state) benchmark::DoNotOptimize(shadow_map(maps, 0.7f, 0.6f));
}
BENCHMARK(BM_ShadowMap)->Unit(benchmark::kMillisecond);

constexpr int kEnds = 1285, kPicks = 3058, kWindow = 2048;  // texels per side of a map that is completely visible

/// Updates drawdown, layout and maps of the front face after a painted cell, with a number of horizons (the preview
/// bakes 4 if texels are as wide as threads).
void paint(benchmark::State& state, Design now, const std::function<void(Draft&)>& flip) {
  BitMatrix cells = drawdown(now.draft);
  Cloth cloth = laid_out(now);
  Maps maps = bake(cloth, {kWindow, kWindow, static_cast<int>(state.range(0)), 0});
  Design next = now;
  for (auto _ : state) {
    flip(next.draft);
    update_drawdown(cells, now.draft, next.draft);
    Cloth after = lay_out(next, cells, Face::kFront, Period::kWholeDraft);
    benchmark::DoNotOptimize(rebake(maps, cloth, after));
    cloth = std::move(after);
    flip(now.draft);
  }
}

void flip(BitMatrix& bits, int row, int col) { bits.set(row, col, !bits.get(row, col)); }

void BM_PaintThreadingCell(benchmark::State& state) {
  // The end is on one shaft or on none.
  paint(state, satin_design(kEnds, kPicks), [](Draft& d) { flip(d.threading, 640, 0); });
}
void BM_PaintTieupCell(benchmark::State& state) {
  paint(state, satin_design(kEnds, kPicks), [](Draft& d) { flip(d.tieup, 3, 5); });
}
void BM_PaintLiftplanCell(benchmark::State& state) {
  paint(state, to_liftplan(satin_design(kEnds, kPicks)), [](Draft& d) { flip(d.liftplan, 1500, 2); });
}
/// One crossing: an end that is alone on its shaft, in one pick.
void BM_PaintOneCrossing(benchmark::State& state) {
  Design design = to_liftplan(satin_design(kEnds, kPicks));
  design.draft.shafts = 9;
  design.draft.threading.resize(kEnds, 9), design.draft.tieup.resize(design.draft.tieup.rows(), 9);
  design.draft.liftplan.resize(kPicks, 9);
  for (int s = 0; s < 8; ++s) design.draft.threading.set(640, s, false);
  design.draft.threading.set(640, 8, true);
  paint(state, design, [](Draft& d) { flip(d.liftplan, 1500, 8); });
}
BENCHMARK(BM_PaintThreadingCell)->Arg(0)->Arg(4)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(BM_PaintTieupCell)->Arg(0)->Arg(4)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(BM_PaintLiftplanCell)->Arg(0)->Arg(4)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(BM_PaintOneCrossing)->Arg(0)->Arg(4)->Unit(benchmark::kMillisecond)->UseRealTime();

void BM_LayOut(benchmark::State& state) {
  const Design d = satin_design(1285, 3058);
  const BitMatrix cells = drawdown(d.draft);
  for (auto _ : state) benchmark::DoNotOptimize(lay_out(d, cells, Face::kFront, Period::kWholeDraft));
}
BENCHMARK(BM_LayOut)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace weftlight::cloth
