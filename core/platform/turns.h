#pragma once
// How a program with a window goes on: in a loop of its own, or by turns that the system gives it.

#include <functional>

namespace weftlight::platform {

/// Calls `turn` until it returns false. Where the system has a loop of its own, as a browser has, it returns at once,
/// and `turn` is called before each picture that the system shows: what it uses must be its own.
void take_turns(std::function<bool()> turn);

}  // namespace weftlight::platform
