#pragma once
// The sRGB curve as tables, for loops over texels.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace weftlight::cloth {

/// Linear values are clamped to 0..1.
class SrgbTable {
 public:
  static const SrgbTable& get();

  /// The linear value of a stored byte.
  float decoded(uint8_t byte) const { return decoded_[byte]; }
  /// The byte to store, rounded.
  uint8_t encoded_byte(float linear) const {
    return bytes_[static_cast<size_t>(std::clamp(linear, 0.0f, 1.0f) * kByteSteps + 0.5f)];
  }
  /// 0..1, between two steps of the table; its error of 0.0004 is a tenth of an 8-bit step.
  float encoded(float linear) const {
    const float x = std::clamp(linear, 0.0f, 1.0f) * kSteps;
    const size_t i = std::min(static_cast<size_t>(x), encoded_.size() - 2);
    return encoded_[i] + (encoded_[i + 1] - encoded_[i]) * (x - static_cast<float>(i));
  }

 private:
  SrgbTable();
  static constexpr int kByteSteps = 16384, kSteps = 4096;
  std::array<float, 256> decoded_;
  std::array<uint8_t, kByteSteps + 1> bytes_;
  std::array<float, kSteps + 1> encoded_;
};

}  // namespace weftlight::cloth
