#include "session/library/library.h"

#include <algorithm>
#include <cctype>
#include <filesystem>

#include "base/resources.h"
#include "base/text.h"
#include "platform/file.h"

namespace weftlight::session {

using base::mark, base::presets_dir, base::tr;

namespace {

// The names that are shipped, for the catalogue of texts: they are made of the names of the files.
[[maybe_unused]] constexpr const char* kShipped[] = {mark("Chambray"),
                                                     mark("Chintz"),
                                                     mark("Cotton denim"),
                                                     mark("Cotton twill"),
                                                     mark("Damask"),
                                                     mark("Deflected double weave"),
                                                     mark("Denim"),
                                                     mark("Double weave"),
                                                     mark("Flannel"),
                                                     mark("Gabardine"),
                                                     mark("Gauze"),
                                                     mark("Glen check"),
                                                     mark("Herringbone"),
                                                     mark("Honeycomb"),
                                                     mark("Houndstooth"),
                                                     mark("Huck lace"),
                                                     mark("Ikat"),
                                                     mark("Linen"),
                                                     mark("Linen plain"),
                                                     mark("Log cabin"),
                                                     mark("Organza"),
                                                     mark("Ottoman"),
                                                     mark("Overshot"),
                                                     mark("Oxford"),
                                                     mark("Plain"),
                                                     mark("Polyester satin charmeuse"),
                                                     mark("Satin 8"),
                                                     mark("Shadow weave"),
                                                     mark("Shot taffeta"),
                                                     mark("Silk charmeuse"),
                                                     mark("Silk crepe de chine"),
                                                     mark("Silk satin"),
                                                     mark("Starter"),
                                                     mark("Summer and winter"),
                                                     mark("Tweed"),
                                                     mark("Twill 2 2"),
                                                     mark("Twill damask"),
                                                     mark("Undulating twill"),
                                                     mark("Waffle")};

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
    const std::string folder = presets_dir() + (cloth ? "/cloths" : "/drafts");
    for (const std::string& file : platform::names_in(folder, missing)) {
      const std::filesystem::path path = std::filesystem::path(folder) / file;
      if (path.extension() != ".wif") continue;
      const std::string name = path.stem().string();
      all.push_back({path.string(), (cloth ? "cloth." : "") + name, tr(spoken(name).c_str()), cloth});
    }
    std::sort(all.begin() + first, all.end(),
              [](const LibraryFile& a, const LibraryFile& b) { return a.path < b.path; });
  }
  return all;
}

}  // namespace weftlight::session
