#pragma once
// GLFW, the library of windows, while anybody uses it. For the main thread.

#include <memory>
#include <string>

#include "base/result.h"

namespace weftlight::gl {

class WindowSystem {
 public:
  /// Started by its first user, ended after its last. The error is GLFW's own sentence, as of last_problem().
  static base::Result<std::shared_ptr<WindowSystem>> use();
  ~WindowSystem();
  WindowSystem(const WindowSystem&) = delete;
  WindowSystem& operator=(const WindowSystem&) = delete;

  /// Why the last call of GLFW failed.
  static std::string last_problem();

 private:
  WindowSystem() = default;
};

}  // namespace weftlight::gl
