#include "platform/opened_files.h"

#include <emscripten.h>

#include <cstdlib>

/// The next path that the page was given, or null. To be freed.
EM_JS(char*, page_next_opened, (), {
  const path = Files.nextOpened();
  return path == null ? 0 : allocateUTF8(path);
});

namespace weftlight::platform {

std::vector<std::string> take_opened_files() {
  std::vector<std::string> paths;
  while (char* const path = page_next_opened()) {
    paths.emplace_back(path);
    std::free(path);
  }
  return paths;
}

}  // namespace weftlight::platform
