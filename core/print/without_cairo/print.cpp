// There is no Cairo (WEFTLIGHT_CAIRO is off): nothing is printed, and whoever asks reads why.

#include "print/print.h"

#include "base/text.h"

namespace weftlight::print {
namespace {

base::Failure missing() {
  return base::failure(base::ErrorKind::kOutput,
                       base::tr("this build cannot print; save the draft and print it with the desktop program"));
}

}  // namespace

base::Result<Printed> printed(const Design& /*design*/, PrintFormat /*format*/, const PrintOptions& /*options*/) {
  return missing();
}
base::Result<SheetPicture> picture_of_sheet(const Design& /*design*/, const PrintOptions& /*options*/, int /*sheet*/,
                                            double /*pixels_per_mm*/) {
  return missing();
}
std::string sheet_file(const std::string& out, size_t /*sheet*/, size_t /*sheets*/) { return out; }

}  // namespace weftlight::print
