#include "panels/cell_texture.h"

#include <epoxy/gl.h>

#include "panels/cell_image.h"

namespace weftlight {

CellTexture::~CellTexture() {
  if (name_ != 0) glDeleteTextures(1, &name_);
}

ImTextureID CellTexture::of(const PanelContext& c, const GridPane& p) {
  const Key key{c.revision, c.work.face, c.work.drawdown_style, c.style.dark, p.x.reversed,
                p.x.pitch,  p.x.scroll,  p.y.scroll,            p.x.length,   p.y.length};
  if (name_ == 0 || !(key == key_)) {
    const CellImage image =
        cell_image(c.design.draft, c.cells, c.work.face, c.work.drawdown_style, c.style.color, p.x, p.y);
    if (name_ == 0) glGenTextures(1, &name_);
    glBindTexture(GL_TEXTURE_2D, name_);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, image.width, image.height, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                 image.pixels.data());
    key_ = key;
  }
  return reinterpret_cast<ImTextureID>(static_cast<intptr_t>(name_));
}

}  // namespace weftlight
