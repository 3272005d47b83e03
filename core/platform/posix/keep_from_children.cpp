#include "platform/keep_from_children.h"

#include <fcntl.h>

namespace weftlight::platform {

void keep_from_children(std::intptr_t handle) { ::fcntl(static_cast<int>(handle), F_SETFD, FD_CLOEXEC); }

}  // namespace weftlight::platform
