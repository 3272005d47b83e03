#pragma once
// Names of files.

#include <string>

namespace weftlight::base {

/// True if both paths lead to one file, or would once it exists; false if one is empty. Asks the disk, which may hang:
/// not for the window's thread.
bool same_file(const std::string& a, const std::string& b);

/// With its dot and in small letters: ".png" of "Cloth.PNG"; empty if there is none.
std::string extension_of(const std::string& path);

}  // namespace weftlight::base
