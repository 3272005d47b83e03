#include "session/file_names.h"

#include <algorithm>
#include <cctype>
#include <filesystem>

namespace weftlight::session {

std::string with_wif_ending(const std::string& path) {
  std::string ending = std::filesystem::path(path).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return ending == ".wif" || path.empty() ? path : path + ".wif";
}

}  // namespace weftlight::session
