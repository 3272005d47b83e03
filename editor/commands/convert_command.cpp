#include <cstdio>

#include "commands/commands.h"

namespace weftlight {

int convert_command(const ConvertOptions&) {
  std::fprintf(stderr, "weftlight: convert is not built yet\n");
  return kUsage;
}

}  // namespace weftlight
