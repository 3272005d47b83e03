#pragma once
// The sRGB curve as tables, for loops over texels.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace weftlight::cloth {

/// Linear values are clamped to 0..1. Through int: processors convert signed numbers at once, unsigned ones in steps.
class SrgbTable {
 public:
  static const SrgbTable& get();

  /// The linear value of a stored byte.
  float decoded(uint8_t byte) const { return decoded_[byte]; }
  /// The byte to store, rounded.
  uint8_t encoded_byte(float linear) const {
    return bytes_[static_cast<size_t>(static_cast<int>(inside(linear) * kByteSteps + 0.5f))];
  }
  /// 0..1, between two steps of the table; its error of 0.0004 is a tenth of an 8-bit step.
  float encoded(float linear) const {
    const float x = inside(linear) * kSteps;
    const int step = std::min(static_cast<int>(x), kSteps - 1);
    const size_t i = static_cast<size_t>(step);
    return encoded_[i] + (encoded_[i + 1] - encoded_[i]) * (x - static_cast<float>(step));
  }

 private:
  SrgbTable();
  static float inside(float linear) { return std::min(std::max(0.0f, linear), 1.0f); }  // NaN becomes 0
  static constexpr int kByteSteps = 16384, kSteps = 4096;
  std::array<float, 256> decoded_;
  std::array<uint8_t, kByteSteps + 1> bytes_;
  std::array<float, kSteps + 1> encoded_;
};

}  // namespace weftlight::cloth
