#pragma once
// Open lines and files stay with this program.

namespace weftlight::platform {

/// A program that is started meanwhile does not inherit this open file or socket.
void keep_from_children(int handle);

}  // namespace weftlight::platform
