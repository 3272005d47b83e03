#pragma once
// A GL texture of the drawdown, drawn again only when its input changes.

#include "ui/pixel_texture.h"
#include "views/draft/draft_context.h"
#include "views/draft/draft_layout.h"

namespace weftlight::views {

using draft::Face;
using session::DrawdownStyle;
using ui::PixelTexture;

class CellTexture {
 public:
  /// `tiled`: the drawdown repeats beyond its edges.
  ImTextureID of(const DraftContext& c, const GridPane& drawdown, bool tiled = false);

 private:
  struct Key {
    uint64_t revision = 0;
    Face face = Face::kFront;
    DrawdownStyle style = DrawdownStyle::kColor;
    bool dark = false, reversed_ends = false, reversed_picks = false, tiled = false;
    float pitch = 0, scroll_x = 0, scroll_y = 0, width = 0, height = 0;
    bool operator==(const Key&) const = default;
  };
  PixelTexture texture_;
  Key key_;
};

}  // namespace weftlight::views
