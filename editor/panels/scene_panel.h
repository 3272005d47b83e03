#pragma once
// The scene the cloth hangs in: drape, method of shading, exposure, light and sky.

#include "panels/panel.h"

namespace weftlight {

MaybeEdit draw_scene(PanelContext& c);

/// Names of the methods as shown, in the order of Method.
const char* method_label(Method method);

}  // namespace weftlight
