#pragma once
// Weaving the draft at a loom.

#include <functional>

#include "session/loom/at_loom.h"

namespace weftlight::actions {

struct LoomActions {
  /// Shows or hides the loom view.
  std::function<void()> toggle;
  std::function<void(bool forwards)> step;
  /// A tabby pick now; and a tabby pick between pattern picks, or no more.
  std::function<void()> tabby, tabby_between;
  /// Says the step aloud.
  std::function<void()> say;
  std::function<void(session::LoomWork)> work;
  std::function<void()> connect, disconnect;
  /// The page for a phone, at the address that is chosen in the loom view.
  std::function<void()> open_page, close_page, renew_code;
  std::function<bool()> serves_page;
};

}  // namespace weftlight::actions
