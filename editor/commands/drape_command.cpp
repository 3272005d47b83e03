#include <cstdio>

#include "commands/commands.h"

namespace weftlight {

int drape_command(const DrapeOptions&) {
  std::fprintf(stderr, "weftlight: drape is not built yet\n");
  return kUsage;
}

}  // namespace weftlight
