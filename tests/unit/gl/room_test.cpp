// Pictures for which the graphics driver has no room.

#include <epoxy/gl.h>

#include "picture.h"

namespace weftlight::gl {

using render_data::square, render_data::twill;

namespace {

TEST_F(PictureTest, APictureThatHasNoRoomIsToldAndTheNextIsDrawn) {
  upload(twill(4, 2, {0.8f, 0.1f, 0.1f}, {0.8f, 0.1f, 0.1f}), square(100));
  const Image before = draw(false);
  GLint most = 0;
  glGetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &most);
  frame.width = most + 1, frame.height = 1;
  const base::Result<void> told = renderer->draw(scene, look, frame).cloth;
  ASSERT_FALSE(told);
  EXPECT_EQ(told.error().kind, base::ErrorKind::kGraphics);
  EXPECT_EQ(problem_of(told), "the graphics driver has no room for a picture of " + std::to_string(most + 1) +
                                  " x 1 pixels; make it smaller");
  EXPECT_FALSE(renderer->measure().cloth) << "it is still so when it is measured";
  frame.width = frame.height = kSide;
  EXPECT_EQ(problem_of(renderer->draw(scene, look, frame).cloth), "");
  EXPECT_EQ(draw(false).texels, before.texels);
}

}  // namespace
}  // namespace weftlight::gl
