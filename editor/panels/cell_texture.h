#pragma once
// A GL texture that holds the drawdown's pixels and is made again only when what it shows has changed.

#include "panels/draft_layout.h"
#include "panels/names.h"
#include "panels/pixel_texture.h"

namespace weftlight::panels {

class CellTexture {
 public:
  ImTextureID of(const PanelContext& c, const GridPane& drawdown);

 private:
  struct Key {
    uint64_t revision = 0;
    Face face = Face::kFront;
    DrawdownStyle look = DrawdownStyle::kColor;
    bool dark = false, reversed = false;
    float pitch = 0, scroll_x = 0, scroll_y = 0, width = 0, height = 0;
    bool operator==(const Key&) const = default;
  };
  PixelTexture texture_;
  Key key_;
};

}  // namespace weftlight::panels
