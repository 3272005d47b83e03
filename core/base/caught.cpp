#include "base/caught.h"

#include <exception>
#include <new>

namespace weftlight::base {
namespace {

std::string words() {
  constexpr const char* kUnknown = "it went wrong for an unknown reason";
  try {
    throw;
  } catch (const std::bad_alloc&) {
    return kNoMemory;
  } catch (const std::exception& e) {
    const std::string said = e.what();
    return said.empty() ? kUnknown : said;
  } catch (...) {
    return kUnknown;
  }
}

}  // namespace

std::string words_of_thrown() noexcept {
  try {
    return words();
  } catch (...) {
    return "no memory";  // so short that it takes none
  }
}

}  // namespace weftlight::base
