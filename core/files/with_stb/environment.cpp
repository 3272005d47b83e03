// Environment maps are not read in this build.

#include "files/environment.h"

#include "base/text.h"

namespace weftlight::files {

base::Result<EnvironmentPicture> read_environment(const std::string& path) {
  return base::failed(check_environment(path));
}

base::Result<void> check_environment(const std::string& path) {
  return base::failure(base::ErrorKind::kInput,
                       base::tr("this build cannot read .hdr or .exr pictures; use the desktop program"), path);
}

}  // namespace weftlight::files
