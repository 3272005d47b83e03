// Based on: Khronos, Data Format 1.3, 2020, chapters on RGTC and BPTC (the layout of the bits, and the weights).

#include "files/block_compression.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace weftlight::files {

namespace {

constexpr int kTexels = 16;

/// Bits of a block, the lowest first.
template <size_t kBytes>
class Bits {
 public:
  void add(uint64_t value, int count) {
    for (int i = 0; i < count; ++i, ++at_)
      bytes_[at_ / 8] = static_cast<uint8_t>(bytes_[at_ / 8] | ((value >> i & 1) << at_ % 8));
  }
  const std::array<uint8_t, kBytes>& bytes() const { return bytes_; }

 private:
  std::array<uint8_t, kBytes> bytes_{};
  size_t at_ = 0;
};

using Color = std::array<float, 4>;
using Colors = std::array<Color, kTexels>;
using Indices = std::array<int, kTexels>;

constexpr std::array<int, kTexels> kWeights{0, 4, 9, 13, 17, 21, 26, 30, 34, 38, 43, 47, 51, 55, 60, 64};

struct Ends {
  Color low{}, high{};
};

/// An end of the line as it is stored: 7 bits a channel, and the lowest bit of all of them.
struct StoredEnd {
  std::array<int, 4> channels{};
  int lowest = 0;
  int value(size_t c) const { return 2 * channels[c] + lowest; }
};

StoredEnd stored_with(const Color& color, int lowest) {
  StoredEnd end{{}, lowest};
  for (size_t c = 0; c < 4; ++c)
    end.channels[c] = std::clamp(static_cast<int>(std::lround((color[c] - static_cast<float>(lowest)) / 2)), 0, 127);
  return end;
}

float error_of(const StoredEnd& end, const Color& color) {
  float sum = 0;
  for (size_t c = 0; c < 4; ++c) {
    const float off = static_cast<float>(end.value(c)) - color[c];
    sum += off * off;
  }
  return sum;
}

StoredEnd stored(const Color& color, bool opaque) {
  const StoredEnd odd = stored_with(color, 1);
  if (opaque) return odd;  // an even end has no alpha of 255
  const StoredEnd even = stored_with(color, 0);
  return error_of(even, color) < error_of(odd, color) ? even : odd;
}

/// The ends as stored, the place of each texel between them, and the error of it all.
struct Fit {
  StoredEnd low, high;
  Indices indices{};
  int error = std::numeric_limits<int>::max();
};

Fit fitted(const Ends& ends, std::span<const uint8_t, 64> rgba, bool opaque) {
  Fit fit{stored(ends.low, opaque), stored(ends.high, opaque), {}, 0};
  std::array<std::array<int, 4>, kTexels> places{};
  for (size_t k = 0; k < kTexels; ++k)
    for (size_t c = 0; c < 4; ++c)
      places[k][c] = ((64 - kWeights[k]) * fit.low.value(c) + kWeights[k] * fit.high.value(c) + 32) >> 6;
  for (size_t i = 0; i < kTexels; ++i) {
    int best = std::numeric_limits<int>::max();
    for (size_t k = 0; k < kTexels; ++k) {
      int error = 0;
      for (size_t c = 0; c < 4; ++c) {
        const int off = places[k][c] - rgba[4 * i + c];
        error += off * off;
      }
      if (error < best) best = error, fit.indices[i] = static_cast<int>(k);
    }
    fit.error += best;
  }
  return fit;
}

/// The line through the mean along which the colours differ most, from the first to the last of them.
Ends along_main_axis(const Colors& colors) {
  Color mean{};
  for (const Color& color : colors)
    for (size_t c = 0; c < 4; ++c) mean[c] += color[c] / kTexels;
  std::array<Color, 4> covariance{};
  for (const Color& color : colors)
    for (size_t a = 0; a < 4; ++a)
      for (size_t b = 0; b < 4; ++b) covariance[a][b] += (color[a] - mean[a]) * (color[b] - mean[b]);
  size_t widest = 0;
  for (size_t c = 1; c < 4; ++c)
    if (covariance[c][c] > covariance[widest][widest]) widest = c;
  Color axis = covariance[widest];
  constexpr int kSteps = 8;
  for (int step = 0; step < kSteps; ++step) {
    Color next{};
    for (size_t a = 0; a < 4; ++a)
      for (size_t b = 0; b < 4; ++b) next[a] += covariance[a][b] * axis[b];
    float length = 0;
    for (const float v : next) length += v * v;
    if (length <= 0) return {mean, mean};  // one colour
    for (size_t c = 0; c < 4; ++c) axis[c] = next[c] / std::sqrt(length);
  }
  float low = 0, high = 0;
  for (const Color& color : colors) {
    float at = 0;
    for (size_t c = 0; c < 4; ++c) at += (color[c] - mean[c]) * axis[c];
    low = std::min(low, at), high = std::max(high, at);
  }
  Ends ends;
  for (size_t c = 0; c < 4; ++c) ends.low[c] = mean[c] + low * axis[c], ends.high[c] = mean[c] + high * axis[c];
  return ends;
}

/// The ends with the least squared error for these places of the texels.
Ends least_squares(const Colors& colors, const Fit& fit) {
  float low2 = 0, both = 0, high2 = 0;
  Color low_sum{}, high_sum{};
  for (size_t i = 0; i < kTexels; ++i) {
    const float high = static_cast<float>(kWeights[static_cast<size_t>(fit.indices[i])]) / 64, low = 1 - high;
    low2 += low * low, both += low * high, high2 += high * high;
    for (size_t c = 0; c < 4; ++c) low_sum[c] += low * colors[i][c], high_sum[c] += high * colors[i][c];
  }
  const float determinant = low2 * high2 - both * both;
  Ends ends;
  for (size_t c = 0; c < 4; ++c) {
    if (determinant < 1e-6f) {  // all at one place
      ends.low[c] = static_cast<float>(fit.low.value(c)), ends.high[c] = static_cast<float>(fit.high.value(c));
      continue;
    }
    ends.low[c] = (high2 * low_sum[c] - both * high_sum[c]) / determinant;
    ends.high[c] = (low2 * high_sum[c] - both * low_sum[c]) / determinant;
  }
  return ends;
}

/// The highest bit of the first index is not stored: it is 0, or the ends change places.
void put_first_index_low(Fit& fit) {
  if (fit.indices[0] < 8) return;
  std::swap(fit.low, fit.high);
  for (int& index : fit.indices) index = 15 - index;
}

Bc7Block mode_6(const Fit& fit) {
  Bits<16> bits;
  bits.add(1u << 6, 7);
  for (size_t c = 0; c < 4; ++c) {
    bits.add(static_cast<uint64_t>(fit.low.channels[c]), 7);
    bits.add(static_cast<uint64_t>(fit.high.channels[c]), 7);
  }
  bits.add(static_cast<uint64_t>(fit.low.lowest), 1), bits.add(static_cast<uint64_t>(fit.high.lowest), 1);
  for (size_t i = 0; i < kTexels; ++i) bits.add(static_cast<uint64_t>(fit.indices[i]), i == 0 ? 3 : 4);
  return bits.bytes();
}

}  // namespace

int bytes_of(BlockFormat format) { return format == BlockFormat::kBc4 ? 8 : 16; }

int channels_of(BlockFormat format) { return format == BlockFormat::kBc4 ? 1 : format == BlockFormat::kBc5 ? 2 : 4; }

Bc4Block compress_bc4(std::span<const uint8_t, 16> values) {
  const auto [low, high] = std::ranges::minmax(values);
  Bits<8> bits;
  bits.add(high, 8), bits.add(low, 8);  // in this order eight values: the two, and six between them
  for (const uint8_t value : values) {
    if (high == low) {
      bits.add(0, 3);
      continue;
    }
    const int from_high = ((high - value) * 14 + (high - low)) / (2 * (high - low));  // 0..7, rounded
    bits.add(from_high == 0 ? 0u : from_high == 7 ? 1u : static_cast<unsigned>(from_high + 1), 3);
  }
  return bits.bytes();
}

Bc7Block compress_bc7(std::span<const uint8_t, 64> rgba) {
  Colors colors{};
  bool opaque = true;
  for (size_t i = 0; i < kTexels; ++i) {
    for (size_t c = 0; c < 4; ++c) colors[i][c] = rgba[4 * i + c];
    opaque = opaque && rgba[4 * i + 3] == 255;
  }
  Fit best = fitted(along_main_axis(colors), rgba, opaque);
  constexpr int kRefinements = 2;
  for (int i = 0; i < kRefinements && best.error > 0; ++i) {
    const Fit next = fitted(least_squares(colors, best), rgba, opaque);
    if (next.error >= best.error) break;
    best = next;
  }
  put_first_index_low(best);
  return mode_6(best);
}

}  // namespace weftlight::files
