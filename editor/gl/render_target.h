#pragma once
// A multisampled render target (four samples a pixel) that resolves to a texture; blending is in linear light.

#include "base/result.h"
#include "files/files.h"
#include "gl/gl_objects.h"

namespace weftlight::gl {

using files::Image;

class RenderTarget {
 public:
  /// 8-bit sRGB for the screen, or half floats for scene-linear pictures.
  explicit RenderTarget(bool half) : half_(half) {}

  /// Binds the multisampled framebuffer at `scale` times the picture's size. An error if there is no memory for it, or
  /// for the picture: there is none then.
  base::Result<void> begin(int width, int height, float scale);
  /// Resolves into texture(), scaled to the picture's size.
  void end();
  GLuint texture() const { return picture_.texture.name(); }
  GLuint framebuffer() const { return picture_.framebuffer.name(); }
  /// Row 0 on top.
  Image read() const;
  /// Bytes of an 8-bit target, row 0 at the bottom.
  void read(std::vector<uint32_t>& pixels) const;

 private:
  struct Resolved {
    GlTexture texture;
    GlFramebuffer framebuffer;
    int width = 0, height = 0;
  };
  void make(Resolved& to, int width, int height);
  void make_samples(int width, int height);
  bool make_all(float scale);

  bool half_;
  int width_ = 0, height_ = 0, drawn_width_ = 0, drawn_height_ = 0;
  GlFramebuffer samples_;
  GlRenderbuffer color_, depth_;
  Resolved small_, picture_;
};

}  // namespace weftlight::gl
