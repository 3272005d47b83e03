#pragma once
// Rulers at the left and lower edge of the flat swatch, from its corner; they follow the zoom.

#include "session/editing/cloth_view.h"
#include "views/common/panel.h"

namespace weftlight::views {

using session::ClothView;

/// What they take of the picture, in pixels; none while there are no rulers: a drape, or a swatch that is turned.
struct ClothRulers {
  float wide = 0, high = 0;
};
ClothRulers rulers_of(const PanelContext& c, const ClothView& view);
/// Over the picture from `a` to `b`.
void draw_cloth_rulers(ImDrawList* dl, const PanelContext& c, const ClothView& view, ClothRulers rulers, ImVec2 a,
                       ImVec2 b);

}  // namespace weftlight::views
