#include "ui/pixel_texture.h"

#include <set>
#include <vector>

#include "opengl/opengl.h"

namespace weftlight::ui {
namespace {

/// Those that are filled, in a window whose context comes back. Of the window's thread, as they are.
std::set<PixelTexture*>& filled() {
  static std::set<PixelTexture*> all;
  return all;
}

/// Names that are given back once a frame has been drawn.
std::vector<unsigned>& replaced() {
  static std::vector<unsigned> names;
  return names;
}

}  // namespace

PixelTexture::~PixelTexture() {
  if constexpr (opengl::kComesBack) filled().erase(this);
  if (name_ != 0) replaced().push_back(name_);
}

void PixelTexture::delete_replaced() {
  if (!replaced().empty()) glDeleteTextures(static_cast<GLsizei>(replaced().size()), replaced().data());
  replaced().clear();
}

void PixelTexture::upload_all() {
  delete_replaced();
  for (PixelTexture* const one : filled()) {
    if (one->name_ != 0) glDeleteTextures(1, &one->name_);
    one->upload(one->width_, one->height_, one->pixels_.data(), one->smooth_);
  }
}

void PixelTexture::set(int width, int height, std::span<const ImU32> pixels, bool smooth) {
  if (name_ != 0) replaced().push_back(name_);
  upload(width, height, pixels.data(), smooth);
  if constexpr (opengl::kComesBack) {
    width_ = width, height_ = height, smooth_ = smooth;
    pixels_.assign(pixels.begin(), pixels.end());
    filled().insert(this);
  }
}

void PixelTexture::upload(int width, int height, const ImU32* pixels, bool smooth) {
  glGenTextures(1, &name_);
  glBindTexture(GL_TEXTURE_2D, name_);
  const GLint filter = smooth ? GL_LINEAR : GL_NEAREST;
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filter);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, pixels);
}

}  // namespace weftlight::ui
