#include <cstdio>

#include "commands/commands.h"

namespace weftlight {

int export_command(const ExportOptions&) {
  std::fprintf(stderr, "weftlight: export is not built yet\n");
  return kUsage;
}

}  // namespace weftlight
