#include "platform/random_bytes.h"

#include <windows.h>
// After it, whose words it needs.
#include <bcrypt.h>

namespace weftlight::platform {

bool fill_random(std::span<uint8_t> bytes) {
  return ::BCryptGenRandom(nullptr, bytes.data(), static_cast<ULONG>(bytes.size()), BCRYPT_USE_SYSTEM_PREFERRED_RNG) ==
         0;
}

}  // namespace weftlight::platform
