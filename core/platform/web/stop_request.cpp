#include "platform/stop_request.h"

namespace weftlight::platform {

std::stop_token stop_when_asked() { return {}; }

void end_as_asked() {}

}  // namespace weftlight::platform
