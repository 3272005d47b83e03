#include "wif/numbers.h"

#include <algorithm>
#include <charconv>
#include <climits>
#include <cmath>
#include <cstdio>

namespace weftlight::wif {

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\f' || c == '\v'; }

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

char upper(char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; }

std::string uppercase(std::string_view text) {
  std::string result(text);
  for (char& c : result) c = upper(c);
  return result;
}

namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

size_t skip_blanks(std::string_view text, size_t at) {
  while (at < text.size() && is_blank(text[at])) ++at;
  return at;
}

/// Reads an integer at `at`; on success moves `at` past it.
bool read_int(std::string_view text, size_t& at, int& out) {
  size_t i = skip_blanks(text, at);
  const bool negative = i < text.size() && text[i] == '-';
  if (i < text.size() && (text[i] == '-' || text[i] == '+')) ++i;
  if (i >= text.size() || !is_digit(text[i])) return false;
  int64_t value = 0;
  for (; i < text.size() && is_digit(text[i]); ++i) {
    if (value <= INT_MAX) value = value * 10 + (text[i] - '0');
  }
  if (value > INT_MAX) value = INT_MAX;
  out = static_cast<int>(negative ? -value : value);
  at = i;
  return true;
}

}  // namespace

std::optional<int> leading_int(std::string_view value) {
  size_t at = 0;
  int result = 0;
  if (!read_int(value, at, result)) return std::nullopt;
  return result;
}

std::optional<double> leading_real(std::string_view value, bool* decimal_comma) {
  size_t start = skip_blanks(value, 0);
  if (start < value.size() && value[start] == '+') ++start;
  if (start >= value.size()) return std::nullopt;
  const char first = value[start];
  if (!is_digit(first) && first != '.' && first != '-' && first != ',') return std::nullopt;
  size_t end = start + (first == '-');
  while (end < value.size() && is_digit(value[end])) ++end;
  double result = 0;
  if (end + 1 < value.size() && value[end] == ',' && is_digit(value[end + 1])) {
    std::string with_point(value.substr(start));
    with_point[end - start] = '.';
    const auto read = std::from_chars(with_point.data(), with_point.data() + with_point.size(), result);
    if (read.ec != std::errc{} || !std::isfinite(result)) return std::nullopt;
    if (decimal_comma) *decimal_comma = true;
    return result;
  }
  const auto read = std::from_chars(value.data() + start, value.data() + value.size(), result);
  if (read.ec != std::errc{} || !std::isfinite(result)) return std::nullopt;
  return result;
}

std::string_view leading_ints(std::string_view value, std::vector<int>& out) {
  out.clear();
  size_t at = 0;
  int number = 0;
  while (read_int(value, at, number)) {
    out.push_back(number);
    const size_t comma = skip_blanks(value, at);
    if (comma >= value.size() || value[comma] != ',') return {};
    at = comma + 1;
  }
  const std::string_view rest = trimmed(value.substr(at));
  return rest.starts_with(';') ? std::string_view{} : rest.substr(0, std::min(rest.find(','), rest.size()));
}

size_t leading_numbers_size(std::string_view value) {
  size_t size = 0;
  for (size_t i = 0; i < value.size(); ++i) {
    const char c = value[i];
    const bool exponent = (c == 'e' || c == 'E') && i > 0 && size == i && i + 1 < value.size() &&
                          (is_digit(value[i + 1]) || value[i + 1] == '-' || value[i + 1] == '+');
    if (exponent || is_digit(c) || c == '.' || c == ',' || c == '-' || c == '+') {
      size = i + 1;
    } else if (!is_blank(c)) {
      break;
    }
  }
  return size;
}

std::optional<bool> word_as_bool(std::string_view value) {
  value = trimmed(value);
  size_t size = 0;
  while (size < value.size() && !is_blank(value[size]) && value[size] != ';') ++size;
  const std::string_view word = value.substr(0, size);
  for (const char* yes : {"true", "on", "yes", "1"}) {
    if (same_word(word, yes)) return true;
  }
  for (const char* no : {"false", "off", "no", "0"}) {
    if (same_word(word, no)) return false;
  }
  return std::nullopt;
}

std::string shortest(float value) {
  char buffer[128];
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::fixed);
  return std::string(buffer, end.ptr);
}

std::string in_units(float mm, double unit_mm) {
  const double units = static_cast<double>(mm) / unit_mm;
  char buffer[512];
  for (int digits = 1; digits < 17; ++digits) {
    // Rounded to significant digits, then written without an exponent.
    const auto end = std::to_chars(buffer, buffer + sizeof buffer, units, std::chars_format::scientific, digits - 1);
    double rounded = 0;
    std::from_chars(buffer, end.ptr, rounded);
    if (static_cast<float>(rounded * unit_mm) == mm) {
      const auto plain = std::to_chars(buffer, buffer + sizeof buffer, rounded, std::chars_format::fixed);
      return std::string(buffer, plain.ptr);
    }
  }
  const auto plain = std::to_chars(buffer, buffer + sizeof buffer, units, std::chars_format::fixed);
  return std::string(buffer, plain.ptr);
}

}  // namespace weftlight::wif
