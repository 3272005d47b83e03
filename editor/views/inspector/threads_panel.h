#pragma once
// Yarn, colour, thickness and spacing of the selected threads, or of the whole warp or weft.

#include <string>

#include "session/editing/document_view.h"
#include "views/common/panel.h"

namespace weftlight::views {

using session::FileUnits, session::MaybeEdit, session::ThreadChoice;

/// `typed`: the text that names the threads while it is typed.
MaybeEdit draw_threads(const PanelContext& c, const ThreadChoice& chosen, const FileUnits& units, std::string& typed);

}  // namespace weftlight::views
