#include "draft/hex_color.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace weftlight::draft {

uint32_t packed_rgb(Rgb c) {
  const auto byte = [](float v) { return static_cast<uint32_t>(std::lround(255 * std::clamp(v, 0.0f, 1.0f))); };
  return byte(c.r) << 16 | byte(c.g) << 8 | byte(c.b);
}

Rgb unpacked_rgb(uint32_t c) {
  const auto part = [c](int shift) { return static_cast<float>((c >> shift) & 255) / 255; };
  return {part(16), part(8), part(0)};
}

std::string hex_of(Rgb color) {
  uint32_t c = packed_rgb(color);
  std::string text = "#000000";
  for (size_t i = 6; i > 0; --i, c >>= 4) text[i] = "0123456789ABCDEF"[c & 15];
  return text;
}

std::optional<Rgb> rgb_from_hex(std::string_view text) {
  uint32_t value = 0;
  if (text.size() != 7 || text[0] != '#') return {};
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data() + 1, end, value, 16);
  if (error != std::errc() || stop != end) return {};
  return unpacked_rgb(value);
}

}  // namespace weftlight::draft
