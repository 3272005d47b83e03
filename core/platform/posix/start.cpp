#include "platform/start.h"

#if defined(__GLIBC__)
#include <malloc.h>
#endif

namespace weftlight::platform {

std::vector<std::string> start(int argc, char** argv) {
#if defined(__GLIBC__)
  // Memory of a megabyte and more goes back to the system as soon as it is freed. By itself glibc raises the size from
  // which it does so with each such block, up to 32 MB, and then keeps them: 50 MB in the window with the starter, 80
  // and more with a draft of 10,000 x 10,000.
  mallopt(M_MMAP_THRESHOLD, 1 << 20);
#endif
  return {argv, argv + argc};
}

void keep_freed_memory() {
#if defined(__GLIBC__)
  mallopt(M_MMAP_THRESHOLD, 32 << 20);  // the most that glibc allows
  mallopt(M_TRIM_THRESHOLD, 512 << 20);
  mallopt(M_TOP_PAD, 16 << 20);
#endif
}

}  // namespace weftlight::platform
