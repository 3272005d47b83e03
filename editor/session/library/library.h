#pragma once
// The shipped drafts and cloths.

#include <string>
#include <vector>

namespace weftlight::session {

struct LibraryFile {
  std::string path, id;  // "/.../denim.wif", "cloth.denim"
  std::string name;      // "Denim", translated
  bool cloth = false;    // a cloth with its yarns; else a draft only
};
/// Cloths before drafts, each sorted by name; empty if the presets are missing.
std::vector<LibraryFile> library_files();

}  // namespace weftlight::session
