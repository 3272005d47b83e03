#include "gl/reset_watch.h"

#include "base/text.h"
#include "opengl/opengl.h"

namespace weftlight::gl {

ResetWatch::ResetWatch() : can_ask_(opengl::can_tell_reset()), resets_(opengl::resets()) {}

bool ResetWatch::is_lost() const { return opengl::resets() != resets_ || (can_ask_ && opengl::was_reset()); }

bool ResetWatch::is_back() const { return opengl::kComesBack && !opengl::was_reset(); }

bool LostContexts::may_begin_again(double lasted_s) {
  constexpr double kLastsS = 60;
  constexpr int kMaxLost = 4;
  count_ = lasted_s < kLastsS ? count_ + 1 : 1;
  return count_ < kMaxLost;
}

base::Error LostContexts::problem() {
  return {base::ErrorKind::kGraphics, base::tr("the graphics driver keeps resetting; update it")};
}

}  // namespace weftlight::gl
