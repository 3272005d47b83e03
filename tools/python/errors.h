#pragma once
// The errors of core as exceptions of Python: weftlight.Error with the file and the line, ValueError for what was asked
// for, MemoryError for memory, weftlight.Cancelled for what was stopped.

#include <pybind11/pybind11.h>

#include <exception>
#include <string>
#include <utility>

#include "base/result.h"

namespace weftlight::python {

namespace py = pybind11;

/// An error on its way to Python; thrown with or without the interpreter's lock.
class Failed : public std::exception {
 public:
  explicit Failed(base::Error error) : error_(std::move(error)), message_(base::message(error_)) {}
  const char* what() const noexcept override { return message_.c_str(); }
  const base::Error& error() const { return error_; }

 private:
  base::Error error_;
  std::string message_;
};

/// The value, or throws the error.
template <class T>
T value_of(base::Result<T> result) {
  if (!result) throw Failed(std::move(result).error());
  if constexpr (!std::is_void_v<T>) return std::move(*result);
}

/// Throws ValueError.
[[noreturn]] void bad_value(const std::string& why);
/// Throws IndexError unless 0 <= index < count. "end 12 is out of range: there are 8"
void check_index(const char* what, int index, int count);

/// The classes of exceptions, and what turns errors into them.
void bind_errors(py::module_& module);

}  // namespace weftlight::python
