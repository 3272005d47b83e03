#pragma once
// Weaving the draft at a loom.

#include <functional>

namespace weftlight::actions {

struct LoomActions {
  /// Shows or hides the loom view.
  std::function<void()> toggle;
  std::function<void(bool forwards)> step;
  std::function<void()> connect, disconnect;
};

}  // namespace weftlight::actions
