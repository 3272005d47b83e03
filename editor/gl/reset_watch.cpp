#include "gl/reset_watch.h"

#include <epoxy/gl.h>

namespace weftlight::gl {

// libepoxy ends the program where a function is called that the driver does not have.
ResetWatch::ResetWatch() : can_ask_(epoxy_gl_version() >= 45 || epoxy_has_gl_extension("GL_KHR_robustness")) {}

bool ResetWatch::is_lost() const { return can_ask_ && glGetGraphicsResetStatus() != GL_NO_ERROR; }

}  // namespace weftlight::gl
