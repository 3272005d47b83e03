#pragma once
// Yarn, colour, thickness and spacing of the selected threads, or of the whole warp or weft.

#include <string>

#include "session/editing/document_view.h"
#include "views/common/panel.h"

namespace weftlight::views {

using session::FileUnits, session::MaybeEdit, session::ThreadChoice;

/// Texts while they are typed.
struct TypedThreads {
  std::string which;      // the threads
  std::string order;      // of their colours
  MaybeEdit order_waits;  // until the typing rests
};

/// Which sett it is that the panel shows and sets.
const char* sett_tip(draft::System system);

MaybeEdit draw_threads(const PanelContext& c, const ThreadChoice& chosen, const FileUnits& units, TypedThreads& typed);

}  // namespace weftlight::views
