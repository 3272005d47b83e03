#include "app/reports.h"

#include <filesystem>
#include <memory>
#include <string>
#include <utility>

#include "base/text.h"
#include "views/analysis/comparison_panel.h"
#include "views/analysis/report_panel.h"

namespace weftlight::app {

using base::tr;
using session::DifferenceView, session::Document, session::DocumentView, session::OpenDocument, session::OpenResult,
    session::OtherDraft;
using views::draw_analysis, views::draw_comparison, views::draw_report;

void Reports::start() {
  const DocumentView& v = editing_.view();
  const bool visible = v.analysis.show_floats || settings_.show_repeat || v.differences.other ||
                       (settings_.inspector && settings_.inspector_tab == kInspectorTab);
  if (!visible) return;
  const Document& d = editing_.document();
  reporter_.on(d.snapshot(), d.cells(), session_.revision(), v.analysis.float_limit, v.differences.other);
}

const Report* Reports::last() const {
  const Report* last = reporter_.last();
  return last != nullptr && session_.is_of_active(last->revision) ? last : nullptr;
}

void Reports::choose_draft() {
  dialogs_.ask_path(
      FileAsk::kOpen, tr("Compare with a draft"), editing_.document().path(), [this](const std::string& path) {
        files_.read(path, [this, path, id = session_.active().id](OpenResult result) {
          if (!result.document) return messages_.report(std::move(result.remarks), path);
          OpenDocument* open = session_.find(id);
          if (open == nullptr) return;
          DifferenceView& differences = open->view.differences;
          differences.other = std::make_shared<const OtherDraft>(OtherDraft{
              std::filesystem::path(path).filename().string(), result.document->now(), result.document->cells()});
          differences.place = -1;
          settings_.inspector = true;
          settings_.inspector_tab = kInspectorTab;
        });
      });
}

bool Reports::update() {
  const std::string problem = reporter_.take_message();
  if (!problem.empty()) messages_.say(problem);
  return reporter_.poll() || !problem.empty();
}

void Reports::draw(PanelContext& c) {
  const DocumentView& v = editing_.view();
  draw_comparison(c, v.differences, last());
  draw_report(c, v.analysis, last());
  draw_analysis(c, analysis_);
}

void Reports::draw_plan(PanelContext& c) { c.wanted.add(views::draw_plan(c, plan_)); }

ComparisonActions Reports::actions() {
  return {.choose_draft = [this] { choose_draft(); }, .report = [this] { return last(); }};
}

}  // namespace weftlight::app
