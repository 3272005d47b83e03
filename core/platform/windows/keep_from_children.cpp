#include "platform/keep_from_children.h"

#include <windows.h>

namespace weftlight::platform {

void keep_from_children(std::intptr_t handle) {
  ::SetHandleInformation(reinterpret_cast<HANDLE>(handle), HANDLE_FLAG_INHERIT, 0);
}

}  // namespace weftlight::platform
