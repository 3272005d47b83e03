#include "base/text.h"

#include <cstdlib>

#include "base/decimals.h"

namespace weftlight::base {

const char* tr_n(const char* one, const char* many, long long count) {
  return platform::translated(one, many, static_cast<unsigned long>(std::llabs(count)));
}

std::string filled(const char* pattern, fmt::format_args values) {
  try {
    return filled_with_point(pattern, values, decimal_point());
  } catch (const fmt::format_error&) {
    return pattern;
  }
}

}  // namespace weftlight::base
