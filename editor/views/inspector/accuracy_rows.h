#pragma once
// The accuracy of the automatic method: limited by the error, which is saved with the draft, or by the time per picture
// on this machine, which is saved with the settings.

#include "views/common/panel.h"

namespace weftlight::views {

using session::MaybeEdit;

/// Draws nothing for another method.
MaybeEdit draw_accuracy(PanelContext& c);

}  // namespace weftlight::views
