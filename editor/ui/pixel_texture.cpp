#include "ui/pixel_texture.h"

#include <set>

#include "opengl/opengl.h"

namespace weftlight::ui {
namespace {

/// Those that are filled, in a window whose context comes back. Of the window's thread, as they are.
std::set<PixelTexture*>& filled() {
  static std::set<PixelTexture*> all;
  return all;
}

}  // namespace

PixelTexture::~PixelTexture() {
  if constexpr (opengl::kComesBack) filled().erase(this);
  for (const unsigned name : names_)
    if (name != 0) glDeleteTextures(1, &name);
}

void PixelTexture::upload_all() {
  for (PixelTexture* const one : filled()) {
    for (unsigned& name : one->names_) {
      if (name != 0) glDeleteTextures(1, &name);
      name = 0;
    }
    one->upload(one->width_, one->height_, one->pixels_.data(), one->smooth_);
  }
}

void PixelTexture::set(int width, int height, std::span<const ImU32> pixels, bool smooth) {
  shown_ = 1 - shown_;
  upload(width, height, pixels.data(), smooth);
  if constexpr (opengl::kComesBack) {
    width_ = width, height_ = height, smooth_ = smooth;
    pixels_.assign(pixels.begin(), pixels.end());
    filled().insert(this);
  }
}

void PixelTexture::upload(int width, int height, const ImU32* pixels, bool smooth) {
  if (name() == 0) glGenTextures(1, &names_[shown_]);
  glBindTexture(GL_TEXTURE_2D, name());
  const GLint filter = smooth ? GL_LINEAR : GL_NEAREST;
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filter);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, pixels);
}

}  // namespace weftlight::ui
