#include "platform/error_line.h"

#include <cstdio>

namespace weftlight::platform {

void write_error_line(const std::string& line) { std::fprintf(stderr, "%s\n", line.c_str()); }

}  // namespace weftlight::platform
