#include "platform/page.h"

#include <emscripten.h>

EM_JS(void, page_copy_link, (const char* bytes, int size), { Weftlight.copyLink(HEAPU8.slice(bytes, bytes + size)); });
EM_JS(int, page_is_touched, (), { return Touch.isSeen() ? 1 : 0; });

namespace weftlight::platform {

bool is_page() { return true; }
bool is_touched() { return page_is_touched() != 0; }
void copy_link(const std::string& draft) { page_copy_link(draft.data(), static_cast<int>(draft.size())); }

}  // namespace weftlight::platform
