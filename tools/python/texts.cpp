#include "python/texts.h"

#include <cctype>
#include <charconv>

namespace weftlight::python {

using draft::Rgb;

namespace {

Rgb hex_color(const std::string& text) {
  unsigned value = 0;
  if (text.size() == 7 && text[0] == '#') {
    const auto read = std::from_chars(text.data() + 1, text.data() + 7, value, 16);
    if (read.ec == std::errc() && read.ptr == text.data() + 7) {
      const auto channel = [value](int shift) { return static_cast<float>(value >> shift & 255u) / 255.0f; };
      return {channel(16), channel(8), channel(0)};
    }
  }
  throw py::value_error(std::string("'").append(text).append("' is no colour: give (r, g, b) of 0 to 1 or '#RRGGBB'"));
}

}  // namespace

Rgb color_of(const py::handle& value) {
  if (py::isinstance<py::str>(value)) return hex_color(value.cast<std::string>());
  const auto channels = py::reinterpret_borrow<py::sequence>(value);
  if (channels.size() != 3) throw py::value_error("a colour has three channels: (r, g, b) of 0 to 1");
  const auto channel = [&channels](size_t i) {
    const double number = PyFloat_AsDouble(py::object(channels[i]).ptr());
    if (PyErr_Occurred()) throw py::error_already_set();
    if (!(number >= 0 && number <= 1)) throw py::value_error("a channel of a colour is a number of 0 to 1");
    return static_cast<float>(number);
  };
  return {channel(0), channel(1), channel(2)};
}

}  // namespace weftlight::python
