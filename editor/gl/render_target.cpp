#include "gl/render_target.h"

#include <algorithm>
#include <cmath>

#include "base/text.h"

namespace weftlight::gl {

using base::arg, base::fill, base::tr;
using opengl::decode_srgb, opengl::encode_srgb, opengl::use_multisample;

namespace {

constexpr int kSamples = 4;

void blit(GLuint from, int from_width, int from_height, GLuint to, int width, int height, GLenum filter) {
  glBindFramebuffer(GL_READ_FRAMEBUFFER, from);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, to);
  glBlitFramebuffer(0, 0, from_width, from_height, 0, 0, width, height, GL_COLOR_BUFFER_BIT, filter);
}

}  // namespace

void RenderTarget::make(Resolved& to, int width, int height) {
  if (to.width == width && to.height == height) return;
  to.width = width, to.height = height;
  glBindTexture(GL_TEXTURE_2D, to.texture.get());
  glTexImage2D(GL_TEXTURE_2D, 0, half_ ? GL_RGBA16F : GL_SRGB8_ALPHA8, width, height, 0, GL_RGBA,
               half_ ? GL_HALF_FLOAT : GL_UNSIGNED_BYTE, nullptr);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  // The texture is displayed with its encoded values.
  if (!half_) decode_srgb(false);
  glBindFramebuffer(GL_FRAMEBUFFER, to.framebuffer.get());
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, to.texture.get(), 0);
}

void RenderTarget::make_samples(int width, int height) {
  if (drawn_width_ == width && drawn_height_ == height) return;
  drawn_width_ = width, drawn_height_ = height;
  glBindRenderbuffer(GL_RENDERBUFFER, color_.get());
  glRenderbufferStorageMultisample(GL_RENDERBUFFER, kSamples, half_ ? GL_RGBA16F : GL_SRGB8_ALPHA8, width, height);
  glBindRenderbuffer(GL_RENDERBUFFER, depth_.get());
  glRenderbufferStorageMultisample(GL_RENDERBUFFER, kSamples, GL_DEPTH_COMPONENT24, width, height);
  glBindFramebuffer(GL_FRAMEBUFFER, samples_.get());
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, color_.get());
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth_.get());
}

/// Everything of these sizes that is not there yet, so that a lack of memory is known before anything is drawn.
bool RenderTarget::make_all(float scale) {
  const int w = std::max(1, static_cast<int>(std::lround(static_cast<float>(width_) * scale)));
  const int h = std::max(1, static_cast<int>(std::lround(static_cast<float>(height_) * scale)));
  const bool scaled = w != width_ || h != height_;
  const auto has_size = [](const Resolved& of, int width, int height) {
    return of.width == width && of.height == height;
  };
  if (drawn_width_ == w && drawn_height_ == h && has_size(picture_, width_, height_) &&
      (!scaled || has_size(small_, w, h)))
    return true;
  while (glGetError() != GL_NO_ERROR) {
  }
  make_samples(w, h);
  make(picture_, width_, height_);
  if (scaled) make(small_, w, h);
  bool made = glGetError() == GL_NO_ERROR;
  for (const GLuint one : {samples_.name(), picture_.framebuffer.name(), scaled ? small_.framebuffer.name() : 0}) {
    if (one == 0) continue;
    glBindFramebuffer(GL_FRAMEBUFFER, one);
    made = made && glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
  }
  return made;
}

base::Result<void> RenderTarget::begin(int width, int height, float scale) {
  width_ = width, height_ = height;
  if (!make_all(scale)) {
    // What there is may be as large as a card's memory.
    samples_.reset(), color_.reset(), depth_.reset();
    drawn_width_ = drawn_height_ = 0;
    picture_ = {}, small_ = {};
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    return base::failure(
        base::ErrorKind::kGraphics,
        fill(tr("the graphics driver has no room for a picture of {width} x {height} pixels; make it smaller"),
             arg("width", width), arg("height", height)));
  }
  glBindFramebuffer(GL_FRAMEBUFFER, samples_.name());
  glViewport(0, 0, drawn_width_, drawn_height_);
  use_multisample();
  encode_srgb(true);
  return {};
}

void RenderTarget::end() {
  encode_srgb(true);
  if (drawn_width_ == width_ && drawn_height_ == height_) {
    blit(samples_.get(), width_, height_, picture_.framebuffer.get(), width_, height_, GL_NEAREST);
  } else {
    blit(samples_.get(), drawn_width_, drawn_height_, small_.framebuffer.get(), drawn_width_, drawn_height_,
         GL_NEAREST);
    blit(small_.framebuffer.get(), drawn_width_, drawn_height_, picture_.framebuffer.get(), width_, height_, GL_LINEAR);
  }
  encode_srgb(false);
}

Image RenderTarget::read() const {
  Image image{width_, height_, 4, std::vector<float>(static_cast<size_t>(width_) * static_cast<size_t>(height_) * 4)};
  if (!picture_.framebuffer.name()) return image;
  glBindFramebuffer(GL_READ_FRAMEBUFFER, picture_.framebuffer.name());
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  if (half_) {
    glReadPixels(0, 0, width_, height_, GL_RGBA, GL_FLOAT, image.texels.data());
  } else {
    std::vector<uint8_t> bytes(image.texels.size());
    glReadPixels(0, 0, width_, height_, GL_RGBA, GL_UNSIGNED_BYTE, bytes.data());
    std::transform(bytes.begin(), bytes.end(), image.texels.begin(),
                   [](uint8_t b) { return static_cast<float>(b) / 255.0f; });
  }
  const size_t row = static_cast<size_t>(width_) * 4;
  for (int y = 0; y < height_ / 2; ++y) {
    std::swap_ranges(image.texels.begin() + static_cast<long>(row * static_cast<size_t>(y)),
                     image.texels.begin() + static_cast<long>(row * static_cast<size_t>(y + 1)),
                     image.texels.begin() + static_cast<long>(row * static_cast<size_t>(height_ - 1 - y)));
  }
  return image;
}

void RenderTarget::read(std::vector<uint32_t>& pixels) const {
  pixels.resize(static_cast<size_t>(width_) * static_cast<size_t>(height_));
  if (!picture_.framebuffer.name()) return;
  glBindFramebuffer(GL_READ_FRAMEBUFFER, picture_.framebuffer.name());
  glPixelStorei(GL_PACK_ALIGNMENT, 4);
  glReadPixels(0, 0, width_, height_, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
}

}  // namespace weftlight::gl
