#include "ui/pixel_texture.h"

#include "opengl/opengl.h"

namespace weftlight::ui {

PixelTexture::~PixelTexture() {
  for (const unsigned name : names_)
    if (name != 0) glDeleteTextures(1, &name);
}

void PixelTexture::set(int width, int height, std::span<const ImU32> pixels, bool smooth) {
  shown_ = 1 - shown_;
  if (name() == 0) glGenTextures(1, &names_[shown_]);
  glBindTexture(GL_TEXTURE_2D, name());
  const GLint filter = smooth ? GL_LINEAR : GL_NEAREST;
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filter);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
}

}  // namespace weftlight::ui
