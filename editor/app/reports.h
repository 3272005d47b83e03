#pragma once
// The analysis of the shown draft and its comparison with another one, as the inspector and the drawdown show them.

#include "actions/comparison_actions.h"
#include "app/dialogs.h"
#include "app/draft_files.h"
#include "app/editing.h"
#include "app/messages.h"
#include "app/window.h"
#include "session/files/user_files.h"
#include "session/report.h"
#include "session/session.h"
#include "views/analysis/analysis_panel.h"
#include "views/analysis/plan_panel.h"

namespace weftlight::app {

using actions::ComparisonActions;
using session::Report, session::Reporter, session::Session, session::Settings;
using views::AnalysisState, views::PanelContext, views::PlanState;

class Reports {
 public:
  /// The tab of the inspector that shows the analysis.
  static constexpr int kInspectorTab = 3;

  Reports(Session& session, Editing& editing, Settings& settings, Files& files, Dialogs& dialogs, Messages& messages)
      : session_(session),
        editing_(editing),
        settings_(settings),
        files_(files),
        dialogs_(dialogs),
        messages_(messages) {}

  /// Starts a new report if one is visible and the last is outdated.
  void start();
  /// The last report on the shown draft; null if there is none.
  const Report* last() const;
  /// Asks for a draft to compare with.
  void choose_draft();
  /// Another document is shown.
  void forget() { analysis_ = {}, plan_ = {}; }
  /// True if there is something to show.
  bool update();
  /// The tabs of the inspector: the analysis, and the plan of the cloth.
  void draw(PanelContext& c);
  void draw_plan(PanelContext& c);

  ComparisonActions actions();

 private:
  Session& session_;
  Editing& editing_;
  Settings& settings_;
  Files& files_;
  Dialogs& dialogs_;
  Messages& messages_;
  Reporter reporter_{Window::wake};
  AnalysisState analysis_;
  PlanState plan_;
};

}  // namespace weftlight::app
