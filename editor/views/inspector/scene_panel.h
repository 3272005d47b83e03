#pragma once
// The scene the cloth hangs in: drape, method of shading, exposure, light and sky.

#include "views/common/names.h"
#include "views/common/panel.h"

namespace weftlight::views {

MaybeEdit draw_scene(PanelContext& c);

}  // namespace weftlight::views
