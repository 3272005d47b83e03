#pragma once
// How near the truth the automatic method draws: by the error that is allowed, which the draft keeps, or by the time
// that a picture may take on this machine, which the settings keep.

#include "views/common/names.h"
#include "views/common/panel.h"

namespace weftlight::views {

/// Nothing where the method is not the automatic one.
MaybeEdit draw_accuracy(PanelContext& c);

}  // namespace weftlight::views
