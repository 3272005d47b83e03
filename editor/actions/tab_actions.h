#pragma once
// The tabs of the open drafts.

#include <cstddef>
#include <functional>

namespace weftlight::actions {

struct TabActions {
  std::function<size_t()> count;
  /// Index of the active tab.
  std::function<size_t()> active;
  /// Shows the next tab (1) or the previous (-1).
  std::function<void(int by)> step;
  std::function<void()> close, close_others, close_to_right;
};

}  // namespace weftlight::actions
