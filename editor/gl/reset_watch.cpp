#include "gl/reset_watch.h"

#include "opengl/opengl.h"

namespace weftlight::gl {

ResetWatch::ResetWatch() : can_ask_(opengl::can_tell_reset()) {}

bool ResetWatch::is_lost() const { return can_ask_ && opengl::was_reset(); }

}  // namespace weftlight::gl
