#include "base/translated.h"

#include <cstdlib>

namespace weftlight::base {

const char* tr_n(const char* one, const char* many, long long count) {
  return platform::translated(one, many, static_cast<unsigned long>(std::llabs(count)));
}

const char* tr_n(const char* one, const char* many, const std::string& shown) {
  return tr_n(one, many, shown == "1" ? 1LL : 2LL);
}

}  // namespace weftlight::base
