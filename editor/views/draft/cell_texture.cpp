#include "views/draft/cell_texture.h"

#include "views/common/cell_image.h"

namespace weftlight::views {

ImTextureID CellTexture::of(const DraftContext& c, const GridPane& p, bool tiled) {
  const Key key{c.revision,   c.view.face,  c.settings.drawdown_style,
                c.style.dark, p.x.reversed, p.y.reversed,
                tiled,        p.x.pitch,    p.x.scroll,
                p.y.scroll,   p.x.length,   p.y.length};
  if (texture_.empty() || !(key == key_)) {
    const CellImage image =
        cell_image(c.design, c.cells, c.view.face, c.settings.drawdown_style, c.style.color, p.x, p.y, tiled);
    texture_.set(image.width, image.height, image.pixels);
    key_ = key;
  }
  return texture_.id();
}

}  // namespace weftlight::views
