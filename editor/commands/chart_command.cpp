#include <cstdio>

#include "commands/commands.h"

namespace weftlight {

int chart_command(const ChartOptions&) {
  std::fprintf(stderr, "weftlight: chart is not built yet\n");
  return kUsage;
}

}  // namespace weftlight
