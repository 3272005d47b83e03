#pragma once
// The notice of an edit beyond the loom limits: the reason, and what can be done.

#include <optional>

#include "session/document/rejected_edit.h"
#include "views/common/panel.h"

namespace weftlight::views {

using session::RejectedEdit;

/// At the bottom of a pane, while there is a rejected edit. Draw it after the pane.
void draw_closest_weave_notice(PanelContext& c, const std::optional<RejectedEdit>& rejected, ImVec2 min, ImVec2 max);

}  // namespace weftlight::views
