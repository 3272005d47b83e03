#include "gl/average.h"

#include <gtest/gtest.h>

#include <limits>

#include "gl/open_headless.h"

namespace weftlight::gl {

using base::problem_of;

namespace {

constexpr int kSize = 24;  // of no other texture

/// Fills every half-float texture of that size with NaN, as reused memory may contain.
int poison() {
  const std::vector<float> nan(size_t{4} * kSize * kSize, std::numeric_limits<float>::quiet_NaN());
  int found = 0;
  for (GLuint name = 1; name < 1000; ++name) {
    if (!glIsTexture(name)) continue;
    GLint width = 0, format = 0;
    glBindTexture(GL_TEXTURE_2D, name);
    glGetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_WIDTH, &width);
    glGetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_INTERNAL_FORMAT, &format);
    if (width != kSize || format != GL_RGBA16F) continue;
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, kSize, kSize, GL_RGBA, GL_FLOAT, nan.data());
    ++found;
  }
  glGetError();  // clears errors of names that are no two-dimensional textures
  return found;
}

/// A picture of one grey, with its framebuffer.
struct Picture {
  GlTexture texture;
  GlFramebuffer framebuffer;
  Picture() {
    const std::vector<uint8_t> grey(size_t{4} * kSize * kSize, 128);
    glBindTexture(GL_TEXTURE_2D, texture.get());
    glTexImage2D(GL_TEXTURE_2D, 0, GL_SRGB8_ALPHA8, kSize, kSize, 0, GL_RGBA, GL_UNSIGNED_BYTE, grey.data());
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_SRGB_DECODE_EXT, GL_SKIP_DECODE_EXT);  // as RenderTarget does
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer.get());
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture.get(), 0);
  }
  int middle() {
    std::array<uint8_t, 4> pixel{};
    glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer.get());
    glReadPixels(kSize / 2, kSize / 2, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel.data());
    return pixel[0];
  }
};

// Once the cloth went dark in the window when its picture was refined close up.
TEST(Average, OfEqualPicturesIsThatPictureWhateverItsMemoryHeldBefore) {
  const auto context = open_headless();
  if (!context) GTEST_SKIP() << "no graphics: " << problem_of(context);
  Average average;
  ASSERT_EQ(problem_of(average.build()), "");
  Picture picture;
  average.add(picture.texture.name(), picture.framebuffer.name(), kSize, kSize, 1);
  ASSERT_EQ(poison(), 1);
  for (const float weight : {1.0f, 0.5f, 0.3f}) {
    average.add(picture.texture.name(), picture.framebuffer.name(), kSize, kSize, weight);
    EXPECT_NEAR(picture.middle(), 128, 2) << weight;
  }
}

}  // namespace
}  // namespace weftlight::gl
