#pragma once
// Which state of the source was built.

#include <string>

namespace weftlight::commands {

/// The version with the commit that was built, if it is known: "0.1.0 (795e9cf)", "0.1.0 (795e9cf, changed)".
std::string version_and_commit();

}  // namespace weftlight::commands
