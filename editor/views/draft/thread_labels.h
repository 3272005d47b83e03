#pragma once
// Selecting threads by their numbers beside the colour bars, as the headers of a table select columns. On the bars
// themselves the Select tool does the same, and Shift and Ctrl with any tool.

#include "views/draft/draft_context.h"
#include "views/draft/draft_layout.h"

namespace weftlight::views {

using session::GridId;

/// True while a press on a colour bar selects threads rather than paints.
bool chooses_on_bar(const DraftContext& c, GridId bar);
/// Selects threads on a bar, whose ImGui item was drawn last.
void choose_on_bar(DraftContext& c, const GridPane& bar);
/// Selects threads by their numbers. True while a button pressed there is down.
bool choose_by_labels(DraftContext& c, const DraftLayout& layout);
/// Highlights the selected threads on numbers and bars.
void draw_chosen(ImDrawList* dl, const DraftContext& c, const DraftLayout& layout);

}  // namespace weftlight::views
