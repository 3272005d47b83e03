#pragma once
// What the user or the system asks of a command that runs: to end, as Ctrl+C and a closed terminal do.

#include <stop_token>

namespace weftlight::platform {

/// From the first call on, a request to end this program (Ctrl+C, the signals TERM and HUP, a closed console) asks to
/// stop through the token; a second one ends the program at once. A request that the starter of the program has it
/// ignore is still ignored. Where no system makes such requests, the token cannot be stopped.
std::stop_token stop_when_asked();

/// Ends the program as the request would have ended it, so that its starter knows. Returns if there was none.
void end_as_asked();

}  // namespace weftlight::platform
