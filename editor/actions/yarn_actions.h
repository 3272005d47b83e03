#pragma once
// The library of the user's yarns.

#include <functional>

namespace weftlight::actions {

struct YarnActions {
  std::function<void()> show_library;
  /// Keeps the active yarn in the library.
  std::function<void()> keep;
};

}  // namespace weftlight::actions
