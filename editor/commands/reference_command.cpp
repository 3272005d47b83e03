#include <cstdio>

#include "commands/commands.h"

namespace weftlight {

int reference_command(const PictureOptions&) {
  std::fprintf(stderr, "weftlight: reference is not built yet\n");
  return kUsage;
}

}  // namespace weftlight
