#include "session/files/file_names.h"

#include "base/file_names.h"

namespace weftlight::session {

std::string with_file_ending(const std::string& path, const std::string& wanted) {
  const std::string ending = base::extension_of(path);
  const bool other_wif = wanted == ".wif" && ending == ".wifw";  // used by weaving programs on macOS
  return ending == wanted || other_wif || path.empty() ? path : path + wanted;
}

}  // namespace weftlight::session
