#include <cstdio>

#include "commands/commands.h"

namespace weftlight {

int info_command(const InfoOptions&) {
  std::fprintf(stderr, "weftlight: info is not built yet\n");
  return kUsage;
}

}  // namespace weftlight
