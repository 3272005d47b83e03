#include <cstdio>

#include "commands/commands.h"

namespace weftlight {

int drawdown_command(const DrawdownOptions&) {
  std::fprintf(stderr, "weftlight: drawdown is not built yet\n");
  return kUsage;
}

}  // namespace weftlight
