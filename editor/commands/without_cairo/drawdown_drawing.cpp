// There is no Cairo (WEFTLIGHT_CAIRO is off): a drawdown is written as a picture or as text.

#include "base/text.h"
#include "commands/drawdown_picture.h"

namespace weftlight::commands {

base::Result<void> write_drawdown_drawing(const std::string& path, const ColoredCells& /*cells*/) {
  return base::failure(base::ErrorKind::kOutput, base::tr("this build cannot write .svg or .pdf; write a .png"), path);
}

}  // namespace weftlight::commands
