#pragma once
// Colours as "#1F3B73".

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "draft/draft.h"

namespace weftlight::draft {

/// Red, green and blue in 8 bits each, red highest; channels outside 0..1 are clamped.
uint32_t packed_rgb(Rgb color);
Rgb unpacked_rgb(uint32_t packed);
/// The nearest colour of 8 bits a channel.
inline Rgb of_8_bits(Rgb color) { return unpacked_rgb(packed_rgb(color)); }

std::string hex_of(Rgb color);
/// Nothing unless the text is # and six digits, of either case.
std::optional<Rgb> rgb_from_hex(std::string_view text);

}  // namespace weftlight::draft
