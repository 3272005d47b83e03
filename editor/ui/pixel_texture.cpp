#include "ui/pixel_texture.h"

#include <epoxy/gl.h>

namespace weftlight::ui {

PixelTexture::~PixelTexture() {
  if (name_ != 0) glDeleteTextures(1, &name_);
}

void PixelTexture::set(int width, int height, std::span<const ImU32> pixels) {
  if (name_ == 0) glGenTextures(1, &name_);
  glBindTexture(GL_TEXTURE_2D, name_);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
}

}  // namespace weftlight::ui
