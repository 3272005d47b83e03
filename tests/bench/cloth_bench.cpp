// Costs named in the paper's section 4 (colour texture under 1 s, 0.5 s a shadow map) and what an edit costs.

#include <benchmark/benchmark.h>

#include "cloth/maps.h"
#include "cloth/moments.h"
#include "draft/edits.h"

namespace weftlight {
namespace {

/// A straight draft of 8 shafts, satin of step 5, of the yarn's own spacing.
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
BENCHMARK(BM_BakeAllMaps)->Args({1024, 16})->Args({1024, 0})->Args({2048, 16})->Unit(benchmark::kMillisecond)->UseRealTime();

void BM_ShadowMap(benchmark::State& state) {
  const Maps maps = bake(laid_out(satin_design(8, 8)), {1024, 1024, 0, 0});
  for (auto _ : state) benchmark::DoNotOptimize(shadow_map(maps, 0.7f, 0.6f));
}
BENCHMARK(BM_ShadowMap)->Unit(benchmark::kMillisecond);

/// Drawdown and maps after one liftplan cell changed: all ends of a shaft in one pick.
void BM_PaintLiftplanCell(benchmark::State& state) {
  Design now = to_liftplan(satin_design(1285, 3058));
  BitMatrix cells = drawdown(now.draft);
  Maps maps = bake(laid_out(now), {2048, 2048, static_cast<int>(state.range(0)), 0});
  for (auto _ : state) {
    Design next = now;
    next.draft.liftplan.set(1500, 2, !next.draft.liftplan.get(1500, 2));
    const CellRect dirty = update_drawdown(cells, now.draft, next.draft);
    benchmark::DoNotOptimize(rebake(maps, lay_out(next, cells, Face::kFront, Period::kWholeDraft), dirty));
    now = std::move(next);
  }
}
BENCHMARK(BM_PaintLiftplanCell)->Arg(0)->Arg(16)->Unit(benchmark::kMillisecond)->UseRealTime();

/// One crossing: what a threading cell changes in one pick.
void BM_PaintOneCrossing(benchmark::State& state) {
  const Design design = satin_design(1285, 3058);
  BitMatrix cells = drawdown(design.draft);
  Maps maps = bake(laid_out(design), {2048, 2048, static_cast<int>(state.range(0)), 0});
  for (auto _ : state) {
    cells.set(1500, 640, !cells.get(1500, 640));
    const Cloth cloth = lay_out(design, cells, Face::kFront, Period::kWholeDraft);
    benchmark::DoNotOptimize(rebake(maps, cloth, {640, 641, 1500, 1501}));
  }
}
BENCHMARK(BM_PaintOneCrossing)->Arg(0)->Arg(16)->Unit(benchmark::kMillisecond)->UseRealTime();

void BM_LayOut(benchmark::State& state) {
  const Design d = satin_design(1285, 3058);
  const BitMatrix cells = drawdown(d.draft);
  for (auto _ : state) benchmark::DoNotOptimize(lay_out(d, cells, Face::kFront, Period::kWholeDraft));
}
BENCHMARK(BM_LayOut)->Unit(benchmark::kMillisecond);

void BM_Moments(benchmark::State& state) {
  const Cloth cloth = laid_out(satin_design(8, 8));
  const Maps maps = bake(cloth, {1024, 1024, 16, 0});
  for (auto _ : state) benchmark::DoNotOptimize(moments(cloth, maps, 512, 512));
}
BENCHMARK(BM_Moments)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace weftlight
