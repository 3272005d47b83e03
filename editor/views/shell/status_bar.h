#pragma once
// The status bar: what is under the pointer, the size of the draft, the messages about the file.

#include <span>
#include <string>

#include "session/editing/drawing_state.h"
#include "session/editing/select_state.h"
#include "views/common/panel.h"
#include "wif/wif.h"

namespace weftlight::views {

using draft::Draft;
using session::DrawingState, session::SelectState;
using wif::Diagnostic;

/// What was just done ("Saved"), or could not be done.
struct StatusMessage {
  std::string text;  // empty: none
  bool refusal = false;
};

/// `trouble`: what could not be written, or empty; it replaces all else. `message` stands first, beside what is
/// under the pointer. True if the button of the messages was clicked.
bool draw_status_bar(PanelContext& c, const SelectState& select, const DrawingState& drawing,
                     const std::string& trouble, const StatusMessage& message, std::span<const Diagnostic> remarks);
/// "48 ends x 60 picks 4 shafts 6 treadles rising shed".
std::string summary(const Draft& draft);

/// The window of messages about the opened file: line, problem, remedy.
void draw_remarks(PanelContext& c, std::span<const Diagnostic> remarks, bool& open);

}  // namespace weftlight::views
