#pragma once
// The rulers of the drawdown: where each thread lies in the cloth, as the draft is drawn.

#include "views/draft/draft_context.h"
#include "views/draft/draft_layout.h"

namespace weftlight::views {

/// In the gutter that the layout leaves at the drawdown, if the settings have rulers.
void draw_draft_rulers(ImDrawList* dl, const DraftContext& c, const DraftLayout& l);

}  // namespace weftlight::views
