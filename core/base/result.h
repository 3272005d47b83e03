#pragma once
// What a function that can fail returns: its value, or one error in the user's words.
//
//   Result<Mesh> read = read_mesh(path);
//   if (!read) return failed(read);                                      passes the error on
//   return failure(ErrorKind::kInput, tr("has no triangles"), path);     begins one
//
// Result<void> is what writes: `return {};` when done. Several problems of one input, or warnings beside a value, are a
// list of their own (wif::Diagnostic). Exceptions of libraries are caught where the library is called.

#include <string>
#include <tl/expected.hpp>
#include <utility>

#include "base/mark.h"

namespace weftlight::base {

/// What has to change for the next try. The exit code of a verb follows from it (commands/commands.h).
enum class ErrorKind {
  kUsage,      // the request: give another option or value
  kInput,      // what is read or drawn
  kOutput,     // the place that is written to
  kGraphics,   // the graphics of the system
  kCancelled,  // nothing: the user stopped it
  kMemory,     // the memory, which did not suffice
};

struct Error {
  ErrorKind kind = ErrorKind::kInput;
  std::string text;    // what is wrong and what to do, in the user's language
  std::string file{};  // the file that it is about; empty: none
  int line = 0;        // of that file, from 1; 0: the file as a whole
};

/// "cloth.glb:12: what is wrong; what to do", without the parts that are not known.
std::string message(const Error& error);

template <class T>
using Result = tl::expected<T, Error>;
using Failure = tl::unexpected<Error>;

inline Failure failure(ErrorKind kind, std::string text, std::string file = {}, int line = 0) {
  return Failure({kind, std::move(text), std::move(file), line});
}
/// The error of a result, as that of another.
template <class T>
Failure failed(Result<T>& result) {
  return Failure(std::move(result).error());
}
template <class T>
Failure failed(const Result<T>& result) {
  return Failure(result.error());
}

/// The message of a failed result, for a line that is only shown; empty if it succeeded.
template <class T>
std::string problem_of(const Result<T>& result) {
  return result ? std::string{} : message(result.error());
}

inline constexpr const char* kNoMemory = mark("there is not enough memory");
/// Inside a catch block: the text of the exception. Never empty.
std::string words_of_thrown() noexcept;
/// Inside a catch block: what was thrown, as an error about `file`. Without memory it is of kMemory, else of `kind`.
Failure thrown(ErrorKind kind, std::string file = {});

}  // namespace weftlight::base
