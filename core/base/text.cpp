#include "base/text.h"

#include <cstdlib>

namespace weftlight::base {

const char* tr_n(const char* one, const char* many, long long count) {
  return platform::translated(one, many, static_cast<unsigned long>(std::llabs(count)));
}

std::string filled(const char* pattern, fmt::format_args values) {
  try {
    return fmt::vformat(pattern, values);
  } catch (const fmt::format_error&) {
    return pattern;
  }
}

}  // namespace weftlight::base
