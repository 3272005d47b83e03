#include "cloth/srgb_table.h"

#include "design/srgb.h"

namespace weftlight::cloth {

using design::srgb_decoded, design::srgb_encoded;

const SrgbTable& SrgbTable::get() {
  static const SrgbTable table;
  return table;
}

SrgbTable::SrgbTable() {
  for (size_t i = 0; i < decoded_.size(); ++i) decoded_[i] = srgb_decoded(static_cast<float>(i) / 255.0f);
  for (size_t i = 0; i < bytes_.size(); ++i)
    bytes_[i] = static_cast<uint8_t>(srgb_encoded(static_cast<float>(i) / kByteSteps) * 255.0f + 0.5f);
  for (size_t i = 0; i < encoded_.size(); ++i) encoded_[i] = srgb_encoded(static_cast<float>(i) / kSteps);
}

}  // namespace weftlight::cloth
