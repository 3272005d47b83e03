#include "base/result.h"

#include <new>

#include "base/caught.h"
#include "base/text.h"

namespace weftlight::base {

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
