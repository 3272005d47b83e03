#pragma once
// What a display shows, read from its server.

#include <optional>
#include <string>
#include <utility>

namespace weftlight::gui {

/// The pixels of a rectangle as a PPM file of 8 bits, as far as it is on the screen; empty if the display has gone.
std::string screen_part(const std::string& display, int x, int y, int width, int height);

/// The corner of the largest window on the screen: 0, 0 where no window manager places it. None if there is no window.
std::optional<std::pair<int, int>> corner_of_window(const std::string& display);

/// Returns once every window of the display has taken all input sent so far and has drawn what came of it. A window
/// that does not answer is waited for no longer than ten seconds.
void wait_for_windows(const std::string& display);

}  // namespace weftlight::gui
