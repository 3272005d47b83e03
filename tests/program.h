#pragma once
// The program that is tested: the one that was built beside the test, or another one, such as that for Windows under
// Wine (tests/windows/check.sh), if WEFTLIGHT_PROGRAM names one.

#include <cstdlib>
#include <string>

namespace weftlight {

inline std::string tested_program() {
  const char* other = std::getenv("WEFTLIGHT_PROGRAM");
  return other != nullptr ? other : WEFTLIGHT_BINARY;
}

}  // namespace weftlight
