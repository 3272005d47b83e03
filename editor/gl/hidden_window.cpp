#include "gl/hidden_window.h"

#include "gl/window_system.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <array>
#include <string>
#include <utility>

#include "base/text.h"

namespace weftlight::gl {

using base::arg, base::fill, base::tr;

namespace {

base::Failure none(std::string why) { return base::failure(base::ErrorKind::kGraphics, std::move(why)); }

GLFWwindow* make_window() {
  // Highest version first: some drivers give exactly the requested version.
  constexpr std::array<std::array<int, 2>, 3> kVersions{{{4, 5}, {4, 1}, {3, 3}}};
  glfwDefaultWindowHints();
  glfwWindowHint(GLFW_VISIBLE, GLFW_FALSE);
  glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
  glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
  GLFWwindow* window = nullptr;
  for (const auto& [major, minor] : kVersions) {
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, major);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, minor);
    window = glfwCreateWindow(16, 16, "Weftlight", nullptr, nullptr);
    if (window != nullptr) break;
  }
  glfwDefaultWindowHints();
  return window;
}

class HiddenWindow : public HeadlessContext {
 public:
  HiddenWindow(std::shared_ptr<WindowSystem> system, GLFWwindow* window)
      : system_(std::move(system)), window_(window) {}
  ~HiddenWindow() override { glfwDestroyWindow(window_); }
  base::Result<void> make_current() override {
    glfwMakeContextCurrent(window_);
    if (glfwGetCurrentContext() == window_) return {};
    return none(fill(tr("the OpenGL context of a hidden window cannot be used ({problem}): update the graphics driver"),
                     arg("problem", WindowSystem::last_problem())));
  }
  void release() override { glfwMakeContextCurrent(nullptr); }

 private:
  std::shared_ptr<WindowSystem> system_;  // outlives the window
  GLFWwindow* window_;
};

}  // namespace

HeadlessContext::Opened open_hidden_window() {
  auto system = WindowSystem::use();
  if (!system) return base::failed(system);
  GLFWwindow* window = make_window();
  if (window == nullptr)
    return none(fill(tr("no window with OpenGL 3.3 can be created ({problem}); install or update the graphics driver"),
                     arg("problem", WindowSystem::last_problem())));
  return std::make_unique<HiddenWindow>(std::move(*system), window);
}

}  // namespace weftlight::gl
