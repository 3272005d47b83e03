#pragma once
// The shipped drafts and cloths, as menus and pages name them.

#include <string>
#include <vector>

#include "session/names.h"

namespace weftlight::session {

struct LibraryFile {
  std::string path, id, name;  // "/.../denim.wif", "cloth.denim", "Denim"
  bool cloth = false;          // a whole cloth with its yarns; else a draft
};
/// Cloths before drafts, each by name; empty where the presets are missing.
std::vector<LibraryFile> library_files();

}  // namespace weftlight::session
