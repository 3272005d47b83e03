#include "base/caught.h"

#include <exception>
#include <new>

namespace weftlight::base {
namespace {

std::string words() {
  const char* const unknown = tr("an unknown error");
  try {
    throw;
  } catch (const std::bad_alloc&) {
    return tr(kNoMemory);
  } catch (const std::exception& e) {
    const std::string said = e.what();
    return said.empty() ? unknown : said;
  } catch (...) {
    return unknown;
  }
}

}  // namespace

std::string words_of_thrown() noexcept {
  try {
    return words();
  } catch (...) {
    return "no memory";  // short enough to need no allocation
  }
}

}  // namespace weftlight::base
