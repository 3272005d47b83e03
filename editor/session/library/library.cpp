#include "session/library/library.h"

#include <algorithm>
#include <cctype>
#include <filesystem>

#include "base/resources.h"

namespace weftlight::session {
namespace {

/// "twill_2_2" -> "Twill 2 2".
std::string spoken(std::string name) {
  std::replace(name.begin(), name.end(), '_', ' ');
  if (!name.empty()) name[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(name[0])));
  return name;
}

}  // namespace

std::vector<LibraryFile> library_files() {
  std::vector<LibraryFile> all;
  for (const bool cloth : {true, false}) {
    const auto first = static_cast<std::ptrdiff_t>(all.size());
    std::error_code missing;  // the library is then empty
    for (const auto& entry :
         std::filesystem::directory_iterator(presets_dir() + (cloth ? "/cloths" : "/drafts"), missing)) {
      if (entry.path().extension() != ".wif") continue;
      const std::string name = entry.path().stem().string();
      all.push_back({entry.path().string(), (cloth ? "cloth." : "") + name, spoken(name), cloth});
    }
    std::sort(all.begin() + first, all.end(),
              [](const LibraryFile& a, const LibraryFile& b) { return a.path < b.path; });
  }
  return all;
}

}  // namespace weftlight::session
