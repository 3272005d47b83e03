#pragma once
// Blocks of 4 x 4 texels as graphics cards read them. Channels of 8 bits, texels row by row from the upper left.

#include <array>
#include <cstdint>
#include <span>

namespace weftlight::files {

/// One channel in 8 bytes, two in 16, four in 16.
enum class BlockFormat { kBc4, kBc5, kBc7 };
int bytes_of(BlockFormat format);
int channels_of(BlockFormat format);

using Bc4Block = std::array<uint8_t, 8>;
using Bc7Block = std::array<uint8_t, 16>;

/// One channel, within 1/14 of the range of the block (and half a step of 8 bits).
Bc4Block compress_bc4(std::span<const uint8_t, 16> values);
/// Red, green, blue and alpha, by mode 6 of BC7 alone: all texels of a block lie on one line between two colours, at 16
/// places. An opaque block stays opaque.
Bc7Block compress_bc7(std::span<const uint8_t, 64> rgba);

}  // namespace weftlight::files
