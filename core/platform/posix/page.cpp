#include "platform/page.h"

namespace weftlight::platform {

bool is_page() { return false; }
bool is_touched() { return false; }
void copy_link(const std::string& /*draft*/) {}

}  // namespace weftlight::platform
