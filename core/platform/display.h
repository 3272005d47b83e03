#pragma once
// The connection to the window system, which may go away under a window: the server crashes, or the user's session
// ends.

#include <functional>

namespace weftlight::platform {

/// Has `lost` called once where the window system goes away: on the thread that notices it in the middle of its call
/// (X), on the window's thread (is_display_lost), or on another one if the window's thread hangs in the window library
/// (Wayland). It ends the program, without the window system; other threads that notice it wait for that end. Call it
/// after the window system was opened, again to replace `lost`; empty: no more. Does nothing on other window systems.
void when_display_lost(std::function<void()> lost);

/// True once a compositor (Wayland) went away. Never true for an X server. For the window's thread, which then calls
/// display_lost().
bool is_display_lost();
/// Calls what when_display_lost() was given, as if it had been noticed here.
void display_lost();

}  // namespace weftlight::platform
