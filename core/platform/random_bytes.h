#pragma once
// Bytes that nobody can guess, for codes and tokens.

#include <cstdint>
#include <span>

namespace weftlight::platform {

/// Fills `bytes`, at most 256 of them, from the system's source for secrets. False if it gives none; they are then
/// not to be used.
bool fill_random(std::span<uint8_t> bytes);

}  // namespace weftlight::platform
