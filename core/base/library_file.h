#pragma once
// Libraries of the program that are loaded while it runs.

#include <string>

namespace weftlight::base {

/// libexec/weftlight/NAME beside the folder of the program, or in a folder above it, where the others of its files are
/// found, too (resources.h).
std::string library_file(const std::string& name);

}  // namespace weftlight::base
