#include "platform/opened_files.h"

namespace weftlight::platform {

std::vector<std::string> take_opened_files() { return {}; }

}  // namespace weftlight::platform
