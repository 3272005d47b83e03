#include "base/utf8.h"

#include <map>

namespace weftlight::base {

size_t utf8_sequence(std::string_view text, uint32_t& code) {
  if (text.empty()) return 0;
  const auto byte = [&](size_t i) { return static_cast<uint8_t>(text[i]); };
  const uint8_t first = byte(0);
  if (first < 0x80) {
    code = first;
    return 1;
  }
  const size_t size = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
  if (first < 0xC2 || first > 0xF4 || size > text.size()) return 0;
  code = first & (0x7Fu >> size);
  for (size_t i = 1; i < size; ++i) {
    if ((byte(i) & 0xC0) != 0x80) return 0;
    code = (code << 6) | (byte(i) & 0x3Fu);
  }
  const bool overlong = (size == 3 && code < 0x800) || (size == 4 && code < 0x10000);
  const bool surrogate = code >= 0xD800 && code <= 0xDFFF;
  return overlong || surrogate || code > 0x10FFFF ? 0 : size;
}

bool is_utf8(std::string_view text) {
  uint32_t code = 0;
  while (!text.empty()) {
    const size_t size = utf8_sequence(text, code);
    if (size == 0) return false;
    text.remove_prefix(size);
  }
  return true;
}

std::string as_utf8(std::string_view text) {
  std::string out;
  out.reserve(text.size());
  uint32_t code = 0;
  while (!text.empty()) {
    const size_t size = utf8_sequence(text, code);
    if (size > 0) out.append(text.substr(0, size));
    else out += "\xEF\xBF\xBD";
    text.remove_prefix(size > 0 ? size : 1);
  }
  return out;
}

std::string_view cut_utf8(std::string_view text, size_t bytes) {
  if (text.size() <= bytes) return text;
  const auto continues = [&](size_t at) { return (static_cast<uint8_t>(text[at]) & 0xC0) == 0x80; };
  size_t at = bytes;
  while (at > 0 && bytes - at < 3 && continues(at)) --at;
  return text.substr(0, continues(at) ? bytes : at);
}

std::string plain_latin(uint32_t code) {
  constexpr uint32_t kFirst = 0xC0;
  // U+00C0 to U+017F; * is of more than one letter, or of none.
  constexpr std::string_view kLetters =
      "AAAAAA*CEEEEIIIIDNOOOOO*OUUUUY**aaaaaa*ceeeeiiiidnooooo*ouuuuy*yAaAaAaCcCcCcCcDdDdEeEeEeEeEeGgGg"
      "GgGgHhHhIiIiIiIiIi**JjKkkLlLlLlLlLlNnNnNnnNnOoOoOo**RrRrRrSsSsSsSsTtTtTtUuUuUuUuUuUuWwYyYZzZzZzs";
  static const std::map<uint32_t, const char*> kMore{{0xC6, "AE"},  {0xDE, "Th"},  {0xDF, "ss"},  {0xE6, "ae"},
                                                     {0xFE, "th"},  {0x132, "IJ"}, {0x133, "ij"}, {0x152, "OE"},
                                                     {0x153, "oe"}, {0x1E9E, "SS"}};
  if (const auto more = kMore.find(code); more != kMore.end()) return more->second;
  if (code < kFirst || code - kFirst >= kLetters.size() || kLetters[code - kFirst] == '*') return {};
  return {kLetters[code - kFirst]};
}

}  // namespace weftlight::base
