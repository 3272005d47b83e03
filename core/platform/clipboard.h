#pragma once
// What another program has put on the clipboard, without waiting for one that does not answer.

#include <string>

namespace weftlight::platform {

struct ClipboardText {
  enum class State {
    kText,
    kNone,     // the clipboard is empty, or holds no text, or more than 64 MiB of it
    kOwn,      // this program put it there, and knows it
    kSilent,   // its owner gave no answer within a second, or took more than three in all
    kUnknown,  // the window library has to ask
  };
  State state = State::kUnknown;
  std::string text{};  // UTF-8
};

/// Asks the X server on a connection of its own. `window`: that of the window library, which tells what is ours.
/// kUnknown under any other window system: Wayland gives the clipboard to the window that has the keyboard alone.
ClipboardText clipboard_text(void* window);

}  // namespace weftlight::platform
