// Speed of the drawing tools and of the overview on the largest drafts.

#include <benchmark/benchmark.h>

#include "draft/drawdown.h"
#include "session/editing/shapes.h"
#include "views/common/overview_image.h"
#include "weaves/weaves.h"

namespace {

using weftlight::design::Design;
using weftlight::draft::BitMatrix, weftlight::draft::Draft, weftlight::draft::blank_draft, weftlight::draft::drawdown;
using weftlight::session::ActiveShape, weftlight::session::DocumentView, weftlight::session::GridId,
    weftlight::session::MaybeEdit, weftlight::session::Tool, weftlight::session::finish_shape,
    weftlight::session::region_about;
using weftlight::views::OverviewImage;
using weftlight::weaves::Lean, weftlight::weaves::twill;

constexpr int kLarge = 10000;
constexpr int kWide = 150;  // pixels of the overview

Design large_twill() { return twill({2, 2}, Lean::kRight, {kLarge, kLarge}); }

struct Shown {
  BitMatrix cells = drawdown(large_twill().draft);
  std::vector<ImU32> warp = std::vector<ImU32>(kLarge, IM_COL32(20, 40, 120, 255)),
                     weft = std::vector<ImU32>(kLarge, IM_COL32(230, 220, 200, 255));
  bool follow(OverviewImage& overview) const { return overview.update(cells, true, {warp, weft, {}}, kWide, kWide); }
};

void overview_10000(benchmark::State& state) {
  const Shown shown;
  for (auto _ : state) {
    OverviewImage overview;
    benchmark::DoNotOptimize(shown.follow(overview));
  }
}

void overview_10000_of_an_edit(benchmark::State& state) {
  Shown shown;
  OverviewImage overview;
  shown.follow(overview);
  for (auto _ : state) {
    shown.cells.set(5000, 5000, !shown.cells.get(5000, 5000));
    benchmark::DoNotOptimize(shown.follow(overview));
  }
}

void line_of_10000_ends(benchmark::State& state) {
  const Design design = large_twill();
  for (auto _ : state) {
    DocumentView view;
    view.drawing.shape =
        ActiveShape{Tool::kLine, GridId::kThreading, {0, 0}, {kLarge - 1, design.draft.shafts - 1}, true};
    const MaybeEdit edit = finish_shape(view, design);
    benchmark::DoNotOptimize(edit->apply(design).draft.threading.row(0).data());
  }
}

void fill_of_10000_by_10000(benchmark::State& state) {
  const Draft blank = blank_draft(kLarge, kLarge, 4, 4);
  const BitMatrix cells(kLarge, kLarge);
  for (auto _ : state)
    benchmark::DoNotOptimize(region_about(blank, cells, GridId::kDrawdown, {0, 0}).cells.row(0).data());
}

BENCHMARK(overview_10000)->Unit(benchmark::kMillisecond);
BENCHMARK(overview_10000_of_an_edit)->Unit(benchmark::kMillisecond);
BENCHMARK(line_of_10000_ends)->Unit(benchmark::kMillisecond);
BENCHMARK(fill_of_10000_by_10000)->Unit(benchmark::kMillisecond);

}  // namespace
