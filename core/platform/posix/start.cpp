#include "platform/start.h"

namespace weftlight::platform {

std::vector<std::string> start(int argc, char** argv) { return {argv, argv + argc}; }

}  // namespace weftlight::platform
