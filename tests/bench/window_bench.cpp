// One complete frame of the user interface without a system window and without the picture of the cloth: menus, header,
// grids, inspector, status line, and the difference to the previous frame.

#include <benchmark/benchmark.h>
#include <imgui.h>

#include <memory>
#include <string>
#include <vector>

#include "../unit/actions/bare_editor.h"
#include "screen.h"
#include "session/editing/follow_document.h"
#include "session/report.h"
#include "ui/damage.h"
#include "views/analysis/analysis_panel.h"
#include "views/analysis/plan_panel.h"
#include "views/analysis/report_panel.h"
#include "views/cloth/preview_panel.h"
#include "views/draft/draft_header.h"
#include "views/draft/draft_panel.h"
#include "views/inspector/accuracy_rows.h"
#include "views/inspector/palette_panel.h"
#include "views/inspector/scene_panel.h"
#include "views/inspector/threads_panel.h"
#include "views/inspector/yarn_panel.h"
#include "views/shell/action_list.h"
#include "views/shell/status_bar.h"
#include "views/shell/window_layout.h"

namespace weftlight::bench {

using design::Design;
using draft::ShedControl;
using session::ActionItem, session::Document, session::DocumentView, session::Report, session::report_on,
    session::view_of;
using views::AnalysisState, views::DraftPictures, views::PaneRect, views::PanelContext, views::PlanState,
    views::WindowLayout, views::YarnStrip, views::draw_accuracy, views::draw_analysis, views::draw_context_menu,
    views::draw_draft, views::draw_draft_header, views::draw_menu_bar, views::draw_palette, views::draw_plan,
    views::draw_preview, views::draw_report, views::draw_scene, views::draw_status_bar, views::draw_threads,
    views::draw_yarns, views::lay_out_window;
using weaves::Lean, weaves::twill;

namespace {

enum Tab { kThreads, kYarns, kCloth, kAnalysis, kPlan };

/// Draws like the editor (app/panels.cpp), with its own panel state.
class WholeWindow {
 public:
  explicit WholeWindow(Design design) : editor_(std::move(design)) {
    editor_.view() = view_of(editor_.document());
    report_ = report_on(editor_.document().now(), editor_.document().cells(), 5);
    report_.revision = editor_.document().revision();
  }

  DocumentView& view() { return editor_.view(); }
  const Document& document() const { return editor_.document(); }
  /// Counts what has to be redrawn.
  size_t frame(Screen& screen, Tab tab) {
    screen.frame(editor_.document(), editor_.view(), [&](PanelContext& c) { draw(c, screen, tab); });
    return damage_.changed_areas(screen.drawn()).size();
  }

 private:
  static void begin(const char* name, const PaneRect& pane) {
    ImGui::SetNextWindowPos(pane.at);
    ImGui::SetNextWindowSize({std::max(1.0f, pane.size.x), std::max(1.0f, pane.size.y)});
    ImGui::Begin(name, nullptr, ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove);
  }

  void draw(PanelContext& c, Screen& screen, Tab tab) {
    const DocumentView& v = editor_.view();
    const std::vector<ActionItem> items = actions::show(table_);
    int opens = views::kNoMenu;
    draw_menu_bar(c, items, "draft.wif", opens);
    const ImGuiViewport* view = ImGui::GetMainViewport();
    const WindowLayout l = lay_out_window(screen.style(), view->WorkPos, view->WorkSize, 0.5f, {});
    begin("Draft", l.draft);
    draw_draft_header(c, "draft.wif", v.select.tool, items);
    draw_draft(c, v, &report_, pictures_);
    ImGui::End();
    begin("Cloth", l.cloth);
    draw_preview(c, v.cloth, {}, pane_);
    ImGui::End();
    begin("Inspector", l.inspector);
    draw_tab(c, tab);
    ImGui::End();
    begin("Status", l.status);
    draw_status_bar(c, v.select, v.drawing, {}, {}, {});
    ImGui::End();
    draw_context_menu(c, items, &ActionItem::on_selection, "context", false);
  }

  void draw_tab(PanelContext& c, Tab tab) {
    const DocumentView& v = editor_.view();
    if (tab == kThreads) draw_palette(c, v.drawing), draw_threads(c, v.chosen, v.units, typed_);
    if (tab == kYarns) draw_yarns(c, v.drawing, strip_);
    if (tab == kCloth) draw_scene(c, {}), draw_accuracy(c);
    if (tab == kPlan) draw_plan(c, plan_);
    if (tab != kAnalysis) return;
    draw_report(c, v.analysis, &report_);
    draw_analysis(c, analysis_);
  }

  actions::BareEditor editor_;
  std::vector<actions::Action> table_ = actions::make_actions(editor_.subjects(), {});
  Report report_;
  PlanState plan_;
  DraftPictures pictures_;
  YarnStrip strip_;
  AnalysisState analysis_;
  views::TypedThreads typed_;
  ImVec2 pane_{0, 0};
  ui::Damage damage_;
};

Design starter() { return twill({2, 2}, Lean::kRight, {70, 70}); }
Design jacquard() { return design_of(kJacquard, ShedControl::kTreadling); }
Design large() { return design_of(kLarge, ShedControl::kTreadling); }

/// A frame in which the draft is panned by a few threads; `pitch` 0: it fits and does not move.
void whole_frame(benchmark::State& state, Design (*design)(), float pitch, Tab tab) {
  Screen screen;
  if (!screen.problem().empty()) return state.SkipWithError(screen.problem().c_str());
  WholeWindow window(design());
  for (int i = 0; i < 3; ++i) window.frame(screen, tab);
  window.view().draft.pitch = pitch;
  const int ends = window.document().now().draft.ends(), picks = window.document().now().draft.picks();
  for (auto _ : state) {  // NOLINT(clang-analyzer-deadcode.DeadStores): how Google Benchmark counts
    DocumentView& v = window.view();
    v.draft.scroll_end = static_cast<float>(static_cast<int>(v.draft.scroll_end + 3) % std::max(1, ends / 4));
    v.draft.scroll_pick = static_cast<float>(static_cast<int>(v.draft.scroll_pick + 3) % std::max(1, picks / 4));
    benchmark::DoNotOptimize(window.frame(screen, tab));
  }
}

BENCHMARK_CAPTURE(whole_frame, starter_threads, starter, 0.0f, kThreads)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(whole_frame, starter_yarns, starter, 0.0f, kYarns)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(whole_frame, starter_cloth, starter, 0.0f, kCloth)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(whole_frame, starter_analysis, starter, 0.0f, kAnalysis)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(whole_frame, 1285_x_3058_near, jacquard, 12.0f, kThreads)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(whole_frame, 1285_x_3058_analysis, jacquard, 12.0f, kAnalysis)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(whole_frame, 10000_near, large, 12.0f, kThreads)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(whole_frame, 10000_far, large, 0.2f, kThreads)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(whole_frame, 10000_analysis, large, 12.0f, kAnalysis)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(whole_frame, 10000_plan, large, 12.0f, kPlan)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace weftlight::bench
