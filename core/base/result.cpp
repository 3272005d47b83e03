#include "base/result.h"

#include <exception>
#include <new>

#include "base/text.h"

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

std::string message(const Error& error) {
  std::string place = error.file;
  if (error.line > 0 && !place.empty()) place += ':';
  if (error.line > 0) place += std::to_string(error.line);
  if (place.empty()) return error.text;
  return fill(tr("{file}: {problem}"), arg("file", place), arg("problem", error.text));
}

Failure thrown(ErrorKind kind, std::string file) {
  std::string text = words_of_thrown();  // moved below: a copy could need the memory that is missing
  try {
    throw;
  } catch (const std::bad_alloc&) {
    kind = ErrorKind::kMemory;
  } catch (...) {
  }
  return failure(kind, std::move(text), std::move(file));
}

}  // namespace weftlight::base
