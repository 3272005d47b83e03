// The bodies of standard_library.h: fast_float reads, fmt writes.

#include "standard_library.h"

#if defined(_LIBCPP_VERSION) && _LIBCPP_VERSION < 14000

#include <fast_float/fast_float.h>
#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>

namespace std {
namespace {

/// fast_float takes what from_chars takes, and a plus sign in no version that is packaged.
template <class T>
from_chars_result read(const char* first, const char* last, T& value) {
  const fast_float::from_chars_result done = fast_float::from_chars(first, last, value);
  return {done.ptr, done.ec};
}

to_chars_result put(char* first, char* last, const string& text) {
  if (text.size() > static_cast<size_t>(last - first)) return {last, errc::value_too_large};
  return {std::copy(text.begin(), text.end(), first), errc()};
}

/// The fewest digits that read back as `value`, and the power of ten of the first.
struct Shortest {
  bool negative = false;
  string digits;
  int exponent = 0;
};

template <class T>
Shortest shortest(T value) {
  const string text = fmt::format("{}", value);  // -ddd.ddd or -d.ddde+xx
  const size_t e = std::min(text.find('e'), text.size());
  Shortest out;
  out.negative = text[0] == '-';
  if (e < text.size()) out.exponent = std::atoi(text.c_str() + e + 1);
  bool after_point = false;
  for (const char c : text.substr(0, e)) {
    if (c == '.') after_point = true;
    if (c < '0' || c > '9') continue;
    if (out.digits.empty() && c == '0') {  // leads
      if (after_point) --out.exponent;
      continue;
    }
    if (!after_point && !out.digits.empty()) ++out.exponent;
    if (after_point && out.digits.empty()) --out.exponent;
    out.digits.push_back(c);
  }
  if (out.digits.empty()) return {out.negative, "0", 0};
  while (out.digits.size() > 1 && out.digits.back() == '0') out.digits.pop_back();
  return out;
}

template <class T>
string in_fixed(T value) {
  const Shortest s = shortest(value);
  const int count = static_cast<int>(s.digits.size());
  string out = s.negative ? "-" : "";
  if (s.exponent < 0) return out + "0." + string(static_cast<size_t>(-s.exponent - 1), '0') + s.digits;
  // Beyond its shortest digits a large number is written with all it has.
  if (count <= s.exponent + 1) return fmt::format("{:.0f}", value);
  const auto whole = static_cast<size_t>(s.exponent + 1);
  return out + s.digits.substr(0, whole) + "." + s.digits.substr(whole);
}

template <class T>
string in_scientific(T value) {
  const Shortest s = shortest(value);
  string out = (s.negative ? "-" : "") + s.digits.substr(0, 1);
  if (s.digits.size() > 1) out += "." + s.digits.substr(1);
  const int size = std::abs(s.exponent);
  return out + (s.exponent < 0 ? "e-" : "e+") + (size < 10 ? "0" : "") + to_string(size);
}

template <class T>
to_chars_result write(char* first, char* last, T value) {
  if (!std::isfinite(value)) return put(first, last, fmt::format("{}", value));
  const string fixed = in_fixed(value), scientific = in_scientific(value);
  return put(first, last, fixed.size() <= scientific.size() ? fixed : scientific);
}

template <class T>
to_chars_result write(char* first, char* last, T value, chars_format format) {
  if (!std::isfinite(value)) return put(first, last, fmt::format("{}", value));
  return put(first, last, format == chars_format::fixed ? in_fixed(value) : in_scientific(value));
}

}  // namespace

from_chars_result from_chars(const char* first, const char* last, double& value) { return read(first, last, value); }
from_chars_result from_chars(const char* first, const char* last, float& value) { return read(first, last, value); }
to_chars_result to_chars(char* first, char* last, double value) { return write(first, last, value); }
to_chars_result to_chars(char* first, char* last, float value) { return write(first, last, value); }
to_chars_result to_chars(char* first, char* last, double value, chars_format format) {
  return write(first, last, value, format);
}
to_chars_result to_chars(char* first, char* last, float value, chars_format format) {
  return write(first, last, value, format);
}
to_chars_result to_chars(char* first, char* last, double value, chars_format format, int precision) {
  if (!std::isfinite(value)) return put(first, last, fmt::format("{}", value));
  const char* how = format == chars_format::fixed ? "{:.{}f}" : "{:.{}e}";
  return put(first, last, fmt::format(fmt::runtime(how), value, precision));
}

}  // namespace std

#endif
