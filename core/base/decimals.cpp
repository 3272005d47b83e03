#include "base/decimals.h"

#include <locale>
#include <string_view>

#include "base/translated.h"

namespace weftlight::base {

namespace {

class Point : public std::numpunct<char> {
 public:
  explicit Point(char point) : point_(point) {}

 protected:
  char do_decimal_point() const override { return point_; }

 private:
  char point_;
};

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// Where the format of the field that begins at `open` ends in a type of floating-point numbers: the place of that
/// type, else 0.
size_t float_type(std::string_view pattern, size_t open, size_t close) {
  const size_t colon = pattern.find(':', open);
  if (colon == std::string_view::npos || colon + 1 >= close) return 0;
  constexpr std::string_view kTypes = "eEfFgG";
  return kTypes.find(pattern[close - 1]) == std::string_view::npos ? 0 : close - 1;
}

/// fmt takes the point of a locale where the format says L.
std::string with_locale_marks(std::string_view pattern) {
  std::string out;
  size_t done = 0;
  for (size_t at = pattern.find('{'); at != std::string_view::npos; at = pattern.find('{', at)) {
    if (at + 1 < pattern.size() && pattern[at + 1] == '{') {
      at += 2;
      continue;
    }
    const size_t close = pattern.find('}', at);
    if (close == std::string_view::npos) break;
    if (const size_t type = float_type(pattern, at, close); type != 0) {
      out.append(pattern.substr(done, type - done)).push_back('L');
      done = type;
    }
    at = close;
  }
  return out.append(pattern.substr(done));
}

}  // namespace

char decimal_point() {
  // Translators: the sign between ones and tenths, as the comma of 1,5.
  const char* point = tr_in("decimal point", ".");
  return point[0] != '\0' && point[1] == '\0' ? point[0] : '.';
}

std::string with_decimal_point(std::string text) {
  const char point = decimal_point();
  for (size_t i = 1; point != '.' && i + 1 < text.size(); ++i)
    if (text[i] == '.' && is_digit(text[i - 1]) && is_digit(text[i + 1])) text[i] = point;
  return text;
}

std::string filled_with_point(const char* pattern, fmt::format_args values, char point) {
  if (point == '.') return fmt::vformat(pattern, values);
  return fmt::vformat(std::locale(std::locale::classic(), new Point(point)), with_locale_marks(pattern), values);
}

}  // namespace weftlight::base
