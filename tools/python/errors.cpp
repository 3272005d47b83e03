#include "python/errors.h"

#include <fmt/format.h>

namespace weftlight::python {

using base::Error, base::ErrorKind, base::message;

namespace {

constexpr const char* kModule = "weftlight._weftlight";

const char* kind_name(ErrorKind kind) {
  switch (kind) {
    case ErrorKind::kOutput:
      return "output";
    case ErrorKind::kGraphics:
      return "graphics";
    case ErrorKind::kCancelled:
      return "cancelled";
    default:
      return "input";
  }
}

py::object text_or_none(const std::string& text) {
  return text.empty() ? py::object(py::none())
                      : py::reinterpret_steal<py::object>(
                            PyUnicode_DecodeFSDefaultAndSize(text.data(), static_cast<Py_ssize_t>(text.size())));
}

/// Sets Python's error. The lock is held.
void set_error(const Error& error) {
  const std::string text = message(error);
  if (error.kind == ErrorKind::kMemory) return PyErr_SetString(PyExc_MemoryError, text.c_str());
  if (error.kind == ErrorKind::kUsage) return PyErr_SetString(PyExc_ValueError, text.c_str());
  const py::object type =
      py::module_::import(kModule).attr(error.kind == ErrorKind::kCancelled ? "Cancelled" : "Error");
  const py::object instance = type(py::reinterpret_steal<py::object>(
      PyUnicode_DecodeUTF8(text.data(), static_cast<Py_ssize_t>(text.size()), "backslashreplace")));
  instance.attr("file") = text_or_none(error.file);
  instance.attr("line") = error.line > 0 ? py::object(py::int_(error.line)) : py::object(py::none());
  instance.attr("kind") = kind_name(error.kind);
  PyErr_SetObject(type.ptr(), instance.ptr());
}

}  // namespace

void bad_value(const std::string& why) { throw py::value_error(why); }

void check_index(const char* what, int index, int count) {
  if (index >= 0 && index < count) return;
  throw py::index_error(fmt::format("{} {} is out of range: there are {}, counted from 0", what, index, count));
}

void bind_errors(py::module_& module) {
  py::dict defaults;
  defaults["file"] = py::none();
  defaults["line"] = py::none();
  defaults["kind"] = "input";
  const auto made = [&module](const char* name, const char* doc, const py::object& base, const py::object& dict) {
    module.attr(name) = py::reinterpret_steal<py::object>(PyErr_NewExceptionWithDoc(
        fmt::format("weftlight.{}", name).c_str(), doc, base.ptr(), dict.is_none() ? nullptr : dict.ptr()));
  };
  made("Error", "What cannot be read, woven, drawn or written; .file, .line and .kind say where.",
       py::reinterpret_borrow<py::object>(PyExc_Exception), defaults);
  made("Cancelled", "Stopped by the progress callback, which returned False.", module.attr("Error"), py::none());
  // NOLINTNEXTLINE(performance-unnecessary-value-param): pybind11 takes a function of this type
  py::register_local_exception_translator([](std::exception_ptr thrown) {
    try {
      if (thrown) std::rethrow_exception(thrown);
    } catch (const Failed& failed) {
      set_error(failed.error());
    }
  });
}

}  // namespace weftlight::python
