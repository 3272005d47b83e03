#pragma once
// The scene: shape and drape of the cloth, light, shading method and exposure.

#include "session/jobs/draper.h"
#include "views/common/panel.h"

namespace weftlight::views {

using session::DrapeState, session::MaybeEdit;

MaybeEdit draw_scene(PanelContext& c, const DrapeState& drape);

}  // namespace weftlight::views
