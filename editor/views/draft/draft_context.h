#pragma once
// What the grids of the draft are drawn from.

#include "session/editing/document_view.h"
#include "session/report.h"
#include "views/common/panel.h"

namespace weftlight::views {

using session::DifferenceView, session::DocumentView, session::DraftView, session::DrawingState, session::Report,
    session::SelectState, session::ThreadChoice;

struct DraftContext : PanelContext {
  const DraftView& view;
  const DrawingState& drawing;
  const SelectState& select;
  const ThreadChoice& chosen;
  const DifferenceView& differences;
  bool show_floats;      // those over the limit are tinted
  const Report* report;  // the latest report, perhaps of an earlier design; null if there is none
};

inline DraftContext draft_context(const PanelContext& panel, const DocumentView& v, const Report* report) {
  return {panel, v.draft, v.drawing, v.select, v.chosen, v.differences, v.analysis.show_floats, report};
}

}  // namespace weftlight::views
