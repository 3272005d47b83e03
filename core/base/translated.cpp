#include "base/translated.h"

#include <cstdlib>

namespace weftlight::base {

const char* tr_n(const char* one, const char* many, long long count) {
  return platform::translated(one, many, static_cast<unsigned long>(std::llabs(count)));
}

}  // namespace weftlight::base
