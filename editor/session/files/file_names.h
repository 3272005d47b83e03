#pragma once
// File endings of typed names.

#include <string>

namespace weftlight::session {

/// Appends `ending` unless the path already has it in any case: "name" becomes "name.wif". ".wifw" counts as ".wif".
std::string with_file_ending(const std::string& path, const std::string& ending);

}  // namespace weftlight::session
