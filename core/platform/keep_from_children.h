#pragma once
// Open lines and files stay with this program.

#include <cstdint>

namespace weftlight::platform {

/// A program that is started meanwhile does not inherit this open file or socket.
void keep_from_children(std::intptr_t handle);
/// For systems where it is no number.
inline void keep_from_children(void* handle) { keep_from_children(reinterpret_cast<std::intptr_t>(handle)); }

}  // namespace weftlight::platform
