#pragma once
// A picture being drawn: four samples a pixel, resolved to a texture, in linear light on the way.

#include "files/files.h"
#include "gl/gl_objects.h"
#include "gl/names.h"

namespace weftlight::gl {

class Target {
 public:
  /// 8-bit sRGB for the screen, or half floats for scene-linear pictures.
  explicit Target(bool half) : half_(half) {}

  /// Binds the multisampled target of `scale` times the picture's size. False with no memory for it.
  bool begin(int width, int height, float scale);
  /// Resolves into texture(), scaled to the picture's size.
  void end();
  GLuint texture() const { return picture_.texture.preview_bake(); }
  GLuint framebuffer() const { return picture_.framebuffer.preview_bake(); }
  /// Row 0 on top.
  Image read() const;
  /// Bytes of a target of 8 bits, row 0 at the bottom.
  void read(std::vector<uint32_t>& pixels) const;

 private:
  struct Resolved {
    GlTexture texture;
    GlFramebuffer framebuffer;
    int width = 0, height = 0;
  };
  void make(Resolved& to, int width, int height);

  bool half_;
  int width_ = 0, height_ = 0, drawn_width_ = 0, drawn_height_ = 0;
  GlFramebuffer samples_;
  GlRenderbuffer color_, depth_;
  Resolved small_, picture_;
};

}  // namespace weftlight::gl
