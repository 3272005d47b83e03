#include "gl/window_system.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "base/text.h"

namespace weftlight::gl {

base::Result<std::shared_ptr<WindowSystem>> WindowSystem::use() {
  static std::weak_ptr<WindowSystem> shared;  // GLFW itself is one for the whole program
  if (std::shared_ptr<WindowSystem> used = shared.lock()) return used;
  if (!glfwInit()) return base::failure(base::ErrorKind::kGraphics, last_problem());
  std::shared_ptr<WindowSystem> started(new WindowSystem);
  shared = started;
  return started;
}

WindowSystem::~WindowSystem() { glfwTerminate(); }

std::string WindowSystem::last_problem() {
  const char* text = nullptr;
  glfwGetError(&text);
  return text != nullptr ? text : base::tr("no reason given");
}

}  // namespace weftlight::gl
