#include "platform/page.h"

#include <emscripten.h>

EM_JS(void, page_copy_link, (const char* bytes, int size), { Weftlight.copyLink(HEAPU8.slice(bytes, bytes + size)); });

namespace weftlight::platform {

bool is_page() { return true; }
void copy_link(const std::string& draft) { page_copy_link(draft.data(), static_cast<int>(draft.size())); }

}  // namespace weftlight::platform
