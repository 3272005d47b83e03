#include "session/editing/strokes.h"

#include <gtest/gtest.h>

namespace weftlight::session {
namespace {

TEST(Strokes, ADragIsOneGesture) {
  Strokes s;
  s.frame(true, true);
  const uint64_t first = s.now();
  s.frame(false, true);
  EXPECT_EQ(s.now(), first);
  EXPECT_TRUE(s.going_on());
  s.frame(false, false);
  EXPECT_FALSE(s.going_on());
  EXPECT_EQ(s.now(), 0u) << "between gestures every edit is a step of its own";
}

TEST(Strokes, ASecondClickIsAnotherGesture) {
  Strokes s;
  s.frame(true, true);
  const uint64_t first = s.now();
  // The control of the first click is still active in the frame in which the button went up, and the next frame
  // already has the second click.
  s.frame(false, true);
  s.frame(true, true);
  EXPECT_NE(s.now(), first);
}

TEST(Strokes, TypingIntoAFieldIsOneGesture) {
  Strokes s;
  s.frame(false, true);
  const uint64_t first = s.now();
  EXPECT_NE(first, 0u);
  s.frame(false, true);
  EXPECT_EQ(s.now(), first);
}

}  // namespace
}  // namespace weftlight::session
