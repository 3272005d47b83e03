#include "base/text.h"

#include "base/decimals.h"

namespace weftlight::base {

std::string filled(const char* pattern, fmt::format_args values) {
  try {
    return filled_with_point(pattern, values, decimal_point());
  } catch (const fmt::format_error&) {
    return pattern;
  }
}

}  // namespace weftlight::base
