#include "platform/random_bytes.h"

#include <unistd.h>
#if defined(__APPLE__)
#include <sys/random.h>
#endif

namespace weftlight::platform {

bool fill_random(std::span<uint8_t> bytes) { return ::getentropy(bytes.data(), bytes.size()) == 0; }

}  // namespace weftlight::platform
