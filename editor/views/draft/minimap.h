#pragma once
// The whole drawdown small in a corner of its pane, while the pane shows only a part: a frame stands about that part,
// a click or drag moves it.

#include "ui/pixel_texture.h"
#include "views/common/names.h"
#include "views/common/overview_image.h"
#include "views/common/panel.h"
#include "views/draft/draft_layout.h"

namespace weftlight::views {

class Minimap {
 public:
  /// To be called before the grids take the mouse: it lies above them.
  void apply_input(PanelContext& c, const DraftLayout& layout);
  /// To be called after the grids are drawn.
  void draw(ImDrawList* dl, const PanelContext& c, const DraftLayout& layout);

 private:
  void follow(const PanelContext& c, int width, int height);

  OverviewImage overview_;
  PixelTexture texture_;
  struct Key {
    uint64_t revision = 0;
    Face face = Face::kFront;
    bool structure = false, dark = false;
    int width = 0, height = 0;
    bool operator==(const Key&) const = default;
  };
  Key key_;
};

}  // namespace weftlight::views
