#pragma once
// Says texts aloud, through a program of the system, on a thread of its own. A newer text ends the one before.

#include <string>

#include "base/tasks.h"

namespace weftlight::session {

class Speaker {
 public:
  /// Looks for a program once.
  Speaker();
  bool is_there() const { return !program_.empty(); }
  /// Does nothing without a program.
  void say(const std::string& text);

 private:
  std::string program_;
  base::TaskRunner runner_;
};

}  // namespace weftlight::session
