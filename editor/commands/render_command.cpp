#include <cstdio>

#include "commands/commands.h"

namespace weftlight {

int render_command(const PictureOptions&) {
  std::fprintf(stderr, "weftlight: render is not built yet\n");
  return kUsage;
}

}  // namespace weftlight
