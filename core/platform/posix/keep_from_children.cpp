#include "platform/keep_from_children.h"

#include <fcntl.h>

namespace weftlight::platform {

void keep_from_children(int handle) { ::fcntl(handle, F_SETFD, FD_CLOEXEC); }

}  // namespace weftlight::platform
