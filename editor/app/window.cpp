#include "app/window.h"

#include <epoxy/gl.h>
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

#include <algorithm>
#include <cctype>
#include <utility>

#include "app/fonts.h"

namespace weftlight {
namespace {

std::string key_name(int key, int scancode) {
  if (key >= GLFW_KEY_F1 && key <= GLFW_KEY_F12) return std::string("F").append(std::to_string(key - GLFW_KEY_F1 + 1));
  if (key == GLFW_KEY_KP_ADD) return "+";
  if (key == GLFW_KEY_KP_SUBTRACT) return "-";
  // The letter on the key, whatever the keyboard's layout.
  const char* name = glfwGetKeyName(key, scancode);
  if (name == nullptr) return {};
  std::string text = name;
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return text == "=" ? "+" : text;
}

std::string shortcut(int key, int scancode, int mods) {
  const std::string name = key_name(key, scancode);
  if (name.empty()) return {};
#ifdef __APPLE__
  const bool control = mods & GLFW_MOD_SUPER;
#else
  const bool control = mods & GLFW_MOD_CONTROL;
#endif
  const bool sign = name == "+";  // typed with Shift on some layouts
  return (control ? "Ctrl+" : "") + std::string((mods & GLFW_MOD_SHIFT) && !sign ? "Shift+" : "") +
         ((mods & GLFW_MOD_ALT) ? "Alt+" : "") + name;
}

struct Inbox {
  bool* happened;
  std::vector<std::string>* keys;
  std::vector<std::string>* dropped;
};

Inbox& inbox(GLFWwindow* w) { return *static_cast<Inbox*>(glfwGetWindowUserPointer(w)); }

// Set before ImGui's own, which call these in turn.
void listen(GLFWwindow* w) {
  glfwSetKeyCallback(w, [](GLFWwindow* at, int key, int scancode, int action, int mods) {
    *inbox(at).happened = true;
    if (action == GLFW_RELEASE) return;
    if (std::string text = shortcut(key, scancode, mods); !text.empty()) inbox(at).keys->push_back(std::move(text));
  });
  glfwSetDropCallback(w, [](GLFWwindow* at, int count, const char** paths) {
    *inbox(at).happened = true;
    inbox(at).dropped->assign(paths, paths + count);
  });
  glfwSetCharCallback(w, [](GLFWwindow* at, unsigned) { *inbox(at).happened = true; });
  glfwSetMouseButtonCallback(w, [](GLFWwindow* at, int, int, int) { *inbox(at).happened = true; });
  glfwSetCursorPosCallback(w, [](GLFWwindow* at, double, double) { *inbox(at).happened = true; });
  glfwSetScrollCallback(w, [](GLFWwindow* at, double, double) { *inbox(at).happened = true; });
  glfwSetCursorEnterCallback(w, [](GLFWwindow* at, int) { *inbox(at).happened = true; });
  glfwSetWindowFocusCallback(w, [](GLFWwindow* at, int) { *inbox(at).happened = true; });
  glfwSetWindowSizeCallback(w, [](GLFWwindow* at, int, int) { *inbox(at).happened = true; });
  glfwSetFramebufferSizeCallback(w, [](GLFWwindow* at, int, int) { *inbox(at).happened = true; });
  glfwSetWindowContentScaleCallback(w, [](GLFWwindow* at, float, float) { *inbox(at).happened = true; });
  glfwSetWindowRefreshCallback(w, [](GLFWwindow* at) { *inbox(at).happened = true; });
  glfwSetWindowCloseCallback(w, [](GLFWwindow* at) { *inbox(at).happened = true; });
}

GLFWwindow* make_window(int width, int height) {
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
  glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
  glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
  glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
  glfwWindowHintString(GLFW_X11_CLASS_NAME, "weftlight");
  glfwWindowHintString(GLFW_X11_INSTANCE_NAME, "weftlight");
  return glfwCreateWindow(width, height, "Weftlight", nullptr, nullptr);
}

std::string glfw_problem() {
  const char* text = nullptr;
  glfwGetError(&text);
  return text != nullptr ? text : "no reason given";
}

}  // namespace

std::unique_ptr<Window> Window::open(int width, int height, std::string& error) {
  if (!glfwInit()) {
    error = "the window system cannot be reached (" + glfw_problem() +
            "); without a display, use the verbs: weftlight --help";
    return nullptr;
  }
  std::unique_ptr<Window> w(new Window);
  w->window_ = make_window(width, height);
  if (w->window_ == nullptr) {
    error = "no window with OpenGL 3.3 can be made (" + glfw_problem() + "); install or update the graphics driver";
    return nullptr;
  }
  glfwMakeContextCurrent(w->window_);
  glfwSwapInterval(1);
  glfwSetWindowUserPointer(w->window_, new Inbox{&w->happened_, &w->keys_, &w->dropped_});
  listen(w->window_);
  ImGui::CreateContext();
  ImGui::GetIO().IniFilename = nullptr;
  ImGui_ImplGlfw_InitForOpenGL(w->window_, true);
  ImGui_ImplOpenGL3_Init("#version 330 core");
  return w;
}

Window::~Window() {
  if (window_ != nullptr) {
    if (ImGui::GetCurrentContext() != nullptr) {
      ImGui_ImplOpenGL3_Shutdown();
      ImGui_ImplGlfw_Shutdown();
      ImGui::DestroyContext();
    }
    delete static_cast<Inbox*>(glfwGetWindowUserPointer(window_));
    glfwDestroyWindow(window_);
  }
  glfwTerminate();
}

bool Window::wait(double seconds) {
  if (seconds < 0) glfwWaitEvents();
  else if (seconds == 0) glfwPollEvents();
  else glfwWaitEventsTimeout(seconds);
  return std::exchange(happened_, false);
}

bool Window::wants_close() const { return glfwWindowShouldClose(window_); }
void Window::set_wants_close(bool close) { glfwSetWindowShouldClose(window_, close); }
void Window::set_title(const std::string& title) { glfwSetWindowTitle(window_, title.c_str()); }

float Window::pixel_ratio() const {
  int window = 0, pixels = 0, unused = 0;
  glfwGetWindowSize(window_, &window, &unused);
  glfwGetFramebufferSize(window_, &pixels, &unused);
  return window > 0 && pixels > 0 ? static_cast<float>(pixels) / static_cast<float>(window) : 1.0f;
}

float Window::display_scale() const {
  float x = 1, y = 1;
  glfwGetWindowContentScale(window_, &x, &y);
  return std::clamp(x, 0.75f, 4.0f);
}

void Window::size(int& width, int& height) const { glfwGetWindowSize(window_, &width, &height); }

void Window::use_style(Style& style) {
  const float scale = display_scale();
  style.scale = scale / pixel_ratio();
  style.color = style.dark ? dark_colors() : light_colors();
  if (fonts_for_ != scale) {
    style.font = load_fonts(scale, pixel_ratio());
    ImGui_ImplOpenGL3_DestroyFontsTexture();
    ImGui_ImplOpenGL3_CreateFontsTexture();
    fonts_for_ = scale;
  }
  apply(style);
}

void Window::begin_frame() {
  ImGui_ImplOpenGL3_NewFrame();
  ImGui_ImplGlfw_NewFrame();
  ImGui::NewFrame();
}

void Window::end_frame(ImU32 background) {
  ImGui::Render();
  int width = 0, height = 0;
  glfwGetFramebufferSize(window_, &width, &height);
  const ImVec4 c = ImGui::ColorConvertU32ToFloat4(background);
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  glViewport(0, 0, width, height);
  glDisable(GL_SCISSOR_TEST);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glClearColor(c.x, c.y, c.z, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
  glfwSwapBuffers(window_);
}

std::vector<std::string> Window::take_keys() { return std::exchange(keys_, {}); }
std::vector<std::string> Window::take_dropped_files() { return std::exchange(dropped_, {}); }
double Window::seconds() { return glfwGetTime(); }

}  // namespace weftlight
