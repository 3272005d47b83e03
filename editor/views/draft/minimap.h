#pragma once
// The minimap: the whole drawdown in a corner of its pane, while the pane shows only a part. A frame marks that part;
// click or drag moves it.

#include "ui/pixel_texture.h"
#include "views/common/overview_image.h"
#include "views/draft/draft_context.h"
#include "views/draft/draft_layout.h"

namespace weftlight::views {

using draft::Face;
using ui::PixelTexture;

class Minimap {
 public:
  /// Call before the grids handle the mouse, because it lies above them.
  void apply_input(DraftContext& c, const DraftLayout& layout);
  /// Call after the grids are drawn.
  void draw(ImDrawList* dl, const DraftContext& c, const DraftLayout& layout);

 private:
  void update(const DraftContext& c, int width, int height);

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
