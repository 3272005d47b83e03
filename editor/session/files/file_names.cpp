#include "session/files/file_names.h"

#include <algorithm>
#include <cctype>
#include <filesystem>

namespace weftlight::session {

std::string with_file_ending(const std::string& path, const std::string& wanted) {
  std::string ending = std::filesystem::path(path).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  const bool other_wif = wanted == ".wif" && ending == ".wifw";  // used by weaving programs on macOS
  return ending == wanted || other_wif || path.empty() ? path : path + wanted;
}

}  // namespace weftlight::session
