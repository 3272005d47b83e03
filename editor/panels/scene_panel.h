#pragma once
// The scene the cloth hangs in: drape, method of shading, exposure, light and sky.

#include "panels/names.h"
#include "panels/panel.h"

namespace weftlight::panels {

MaybeEdit draw_scene(PanelContext& c);

}  // namespace weftlight::panels
