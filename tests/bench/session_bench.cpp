// Speed of interaction with the largest drafts: opening, strokes, undo, inverting, saving, and one frame of the grids
// while panning.

#include <benchmark/benchmark.h>
#include <imgui.h>

#include <string>

#include "design/edits.h"
#include "design/selection_edits.h"
#include "screen.h"
#include "session/document/document.h"
#include "session/editing/follow_document.h"
#include "session/editing/paint.h"
#include "views/draft/draft_panel.h"
#include "wif/other_formats.h"
#include "wif/wif.h"

namespace weftlight::bench {

using design::Design, design::with_inverted, design::with_threading;
using draft::BitGrid, draft::Selection, draft::ShedControl, draft::whole_grid;
using session::Document, session::DocumentView, session::Edit, session::view_of;
using views::DraftPictures, views::PanelContext, views::draw_draft;
using wif::WifRead, wif::read_draft, wif::write_new_wif;

namespace {

Edit to_shaft(int shaft) {
  return {"Paint", [shaft](Design d) {
            const int middle = d.draft.ends() / 2;
            return with_threading(std::move(d), middle, shaft, true);
          }};
}

/// Paints a cell of the threading and updates the drawdown; each is a separate undo step.
void stroke(benchmark::State& state, Size size, ShedControl shed_control) {
  Document document(design_of(size, shed_control));
  int shaft = 0;
  for (auto _ : state) benchmark::DoNotOptimize(document.commit(to_shaft(shaft = (shaft + 1) % 32), 0));
}

void undo(benchmark::State& state, Size size, ShedControl shed_control) {
  Document document(design_of(size, shed_control));
  document.commit(to_shaft(5), 0);
  for (auto _ : state) {
    benchmark::DoNotOptimize(document.undo());
    benchmark::DoNotOptimize(document.redo());
  }
}

void invert(benchmark::State& state, BitGrid grid, ShedControl shed_control) {
  Document document(design_of(kLarge, shed_control));
  const Edit edit{"Invert", [grid](Design d) {
                    const Selection all = whole_grid(d.draft, grid);
                    return with_inverted(std::move(d), all);
                  }};
  for (auto _ : state) benchmark::DoNotOptimize(document.commit(edit, 0));
}

void open(benchmark::State& state, Size size, ShedControl shed_control) {
  const std::string bytes = write_new_wif(design_of(size, shed_control));
  for (auto _ : state) {
    WifRead read = read_draft(bytes);
    benchmark::DoNotOptimize(Document(std::move(*read.file), {}, {}).cells().row(0).data());
  }
  state.SetBytesProcessed(state.iterations() * static_cast<int64_t>(bytes.size()));
}

void save(benchmark::State& state, Size size, ShedControl shed_control) {
  WifRead read = read_draft(write_new_wif(design_of(size, shed_control)));
  Document document(std::move(*read.file), {}, {});
  document.commit(to_shaft(5), 0);
  for (auto _ : state) benchmark::DoNotOptimize(document.writer()().size());
}

void draw_grids(PanelContext& c, const DocumentView& view, DraftPictures& pictures) {
  ImGui::SetNextWindowPos({0, 60});
  ImGui::SetNextWindowSize({800, 900});
  ImGui::Begin("Draft", nullptr, ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove);
  draw_draft(c, view, nullptr, pictures);
  ImGui::End();
}

/// One frame of the grids, panned by a few threads, at a number of pixels per thread.
void pan(benchmark::State& state, Size size, float pitch) {
  Screen screen;
  if (!screen.problem().empty()) return state.SkipWithError(screen.problem().c_str());
  const Document document(design_of(size, ShedControl::kTreadling));
  DocumentView view = view_of(document);
  DraftPictures pictures;
  screen.frame(document, view, [&](PanelContext& c) { draw_grids(c, view, pictures); });
  view.draft.pitch = pitch;
  for (auto _ : state) {
    view.draft.scroll_end = static_cast<float>(static_cast<int>(view.draft.scroll_end + 3) % (size.ends / 4));
    view.draft.scroll_pick = static_cast<float>(static_cast<int>(view.draft.scroll_pick + 3) % (size.picks / 4));
    screen.frame(document, view, [&](PanelContext& c) { draw_grids(c, view, pictures); });
  }
}

BENCHMARK_CAPTURE(stroke, 1285_x_3058, kJacquard, ShedControl::kTreadling)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(stroke, 10000_random_liftplan, kLarge, ShedControl::kLiftplan)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(undo, 1285_x_3058, kJacquard, ShedControl::kTreadling)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(undo, 10000_random_liftplan, kLarge, ShedControl::kLiftplan)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(invert, drawdown_10000_treadled, BitGrid::kDrawdown, ShedControl::kTreadling)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(invert, drawdown_10000_random_liftplan, BitGrid::kDrawdown, ShedControl::kLiftplan)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(invert, liftplan_10000, BitGrid::kLiftplan, ShedControl::kLiftplan)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(open, 1285_x_3058, kJacquard, ShedControl::kTreadling)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(open, 10000_random_liftplan, kLarge, ShedControl::kLiftplan)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(save, 1285_x_3058, kJacquard, ShedControl::kTreadling)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(save, 10000_random_liftplan, kLarge, ShedControl::kLiftplan)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(pan, 1285_x_3058_near, kJacquard, 12.0f)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(pan, 1285_x_3058_far, kJacquard, 0.5f)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(pan, 10000_near, kLarge, 12.0f)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(pan, 10000_far, kLarge, 0.2f)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace weftlight::bench
