#include "app/window.h"

#include <epoxy/gl.h>
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

#include <algorithm>
#include <cctype>
#include <deque>
#include <iterator>
#include <utility>

#include "app/fonts.h"

namespace weftlight {
namespace {

constexpr int kButtons = 5;  // as many as ImGui knows

constexpr std::pair<int, const char*> kNamedKeys[] = {
    {GLFW_KEY_KP_ADD, "+"},       {GLFW_KEY_KP_SUBTRACT, "-"}, {GLFW_KEY_LEFT, "Left"},     {GLFW_KEY_RIGHT, "Right"},
    {GLFW_KEY_UP, "Up"},          {GLFW_KEY_DOWN, "Down"},     {GLFW_KEY_DELETE, "Delete"}, {GLFW_KEY_BACKSPACE, "Delete"},
    {GLFW_KEY_INSERT, "Insert"},  {GLFW_KEY_ENTER, "Enter"},   {GLFW_KEY_KP_ENTER, "Enter"}, {GLFW_KEY_ESCAPE, "Escape"}};

std::string key_name(int key, int scancode) {
  if (key >= GLFW_KEY_F1 && key <= GLFW_KEY_F12) return std::string("F").append(std::to_string(key - GLFW_KEY_F1 + 1));
  for (const auto& [named, name] : kNamedKeys)
    if (key == named) return name;
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

struct Window::Inbox {
  struct Mouse {
    double x, y;
    int button;  // -1: a move
    bool down;
    int mods = 0;  // keys held with the button
  };
  bool happened = true;
  struct Key {
    std::string shortcut;
    uint64_t mouse_before;  // mouse events that came before it
  };
  std::vector<std::string> dropped;
  std::deque<Key> keys;
  std::vector<int> pressed;  // keys that went down since the last frame
  std::deque<Mouse> mouse;
  bool down[kButtons] = {};
  double x = -1e6, y = -1e6;  // of the last move
  uint64_t mouse_come = 0, mouse_given = 0, mouse_drawn = 0;  // events so far; drawn: those that the last frame saw

  void add(Mouse event) {
    mouse.push_back(event);
    ++mouse_come;
  }
  static Inbox& of(GLFWwindow* w) { return *static_cast<Inbox*>(glfwGetWindowUserPointer(w)); }
};

// Set before ImGui's own, which call these in turn.
void Window::listen(GLFWwindow* w) {
  glfwSetKeyCallback(w, [](GLFWwindow* at, int key, int scancode, int action, int mods) {
    Inbox::of(at).happened = true;
    if (action == GLFW_RELEASE) return;
    if (key >= 0 && key < IM_ARRAYSIZE(ImGuiIO::KeysDown)) Inbox::of(at).pressed.push_back(key);
    if (std::string text = shortcut(key, scancode, mods); !text.empty()) Inbox::of(at).keys.push_back({std::move(text), Inbox::of(at).mouse_come});
  });
  glfwSetDropCallback(w, [](GLFWwindow* at, int count, const char** paths) {
    Inbox::of(at).happened = true;
    Inbox::of(at).dropped.assign(paths, paths + count);
  });
  glfwSetCharCallback(w, [](GLFWwindow* at, unsigned) { Inbox::of(at).happened = true; });
  glfwSetMouseButtonCallback(w, [](GLFWwindow* at, int button, int action, int mods) {
    Inbox& in = Inbox::of(at);
    // Where the move before it ended: glfwGetCursorPos tells where the pointer is by now, which after a slow
    // frame is somewhere else.
    if (button >= 0 && button < kButtons) in.add({in.x, in.y, button, action == GLFW_PRESS, mods});
    in.happened = true;
  });
  glfwSetCursorPosCallback(w, [](GLFWwindow* at, double x, double y) {
    Inbox& in = Inbox::of(at);
    in.x = x;
    in.y = y;
    in.add({x, y, -1, false});
    in.happened = true;
  });
  glfwSetScrollCallback(w, [](GLFWwindow* at, double, double) { Inbox::of(at).happened = true; });
  glfwSetCursorEnterCallback(w, [](GLFWwindow* at, int entered) {
    Inbox& in = Inbox::of(at);
    // Outside, nothing is under the pointer; a drag keeps it.
    const bool dragging = std::find(std::begin(in.down), std::end(in.down), true) != std::end(in.down);
    if (!entered && !dragging) in.add({-1e6, -1e6, -1, false});
    in.happened = true;
  });
  glfwSetWindowFocusCallback(w, [](GLFWwindow* at, int) { Inbox::of(at).happened = true; });
  glfwSetWindowSizeCallback(w, [](GLFWwindow* at, int, int) { Inbox::of(at).happened = true; });
  glfwSetFramebufferSizeCallback(w, [](GLFWwindow* at, int, int) { Inbox::of(at).happened = true; });
  glfwSetWindowContentScaleCallback(w, [](GLFWwindow* at, float, float) { Inbox::of(at).happened = true; });
  glfwSetWindowRefreshCallback(w, [](GLFWwindow* at) { Inbox::of(at).happened = true; });
  glfwSetWindowCloseCallback(w, [](GLFWwindow* at) { Inbox::of(at).happened = true; });
}

Window::Window() : inbox_(std::make_unique<Inbox>()) {}

void Window::give_mouse() {
  ImGuiIO& io = ImGui::GetIO();
  std::deque<Inbox::Mouse>& mouse = inbox_->mouse;
  inbox_->mouse_drawn = inbox_->mouse_given;
  const auto take = [&] {
    ++inbox_->mouse_given;
    io.MousePos = {static_cast<float>(mouse.front().x), static_cast<float>(mouse.front().y)};
    if (const Inbox::Mouse& event = mouse.front(); event.button >= 0) {
      inbox_->down[event.button] = event.down;
      // As they were with the press, though they be up by now.
      io.KeyCtrl = event.mods & GLFW_MOD_CONTROL;
      io.KeyShift = event.mods & GLFW_MOD_SHIFT;
      io.KeyAlt = event.mods & GLFW_MOD_ALT;
    }
    mouse.pop_front();
  };
  bool moved = false;
  for (; !mouse.empty() && mouse.front().button < 0; moved = true) take();
  // A release after a move waits, so that the drag sees where it ended.
  if (!mouse.empty() && (mouse.front().down || !moved)) take();
  std::copy(std::begin(inbox_->down), std::end(inbox_->down), io.MouseDown);
}

void Window::give_keys() {
  for (int key : inbox_->pressed) ImGui::GetIO().KeysDown[key] = true;
}

void Window::use_crosshair(bool on) {
  ImGuiConfigFlags& flags = ImGui::GetIO().ConfigFlags;
  const bool was = flags & ImGuiConfigFlags_NoMouseCursorChange;
  if (on == was) return;
  if (crosshair_ == nullptr) crosshair_ = glfwCreateStandardCursor(GLFW_CROSSHAIR_CURSOR);
  if (on) glfwSetCursor(window_, crosshair_);
  flags = on ? flags | ImGuiConfigFlags_NoMouseCursorChange : flags & ~ImGuiConfigFlags_NoMouseCursorChange;
}

bool Window::has_input() const { return !inbox_->mouse.empty() || !inbox_->keys.empty(); }

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
  glfwSetWindowUserPointer(w->window_, w->inbox_.get());
  listen(w->window_);
  ImGui::CreateContext();
  ImGui::GetIO().IniFilename = nullptr;
  ImGui::GetIO().ConfigDragClickToInputText = true;
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
    glfwDestroyWindow(window_);
  }
  glfwTerminate();
}

bool Window::wait(double seconds) {
  if (seconds < 0) glfwWaitEvents();
  else if (seconds == 0) glfwPollEvents();
  else glfwWaitEventsTimeout(seconds);
  return std::exchange(inbox_->happened, false);
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
  give_mouse();
  give_keys();
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
  ImGuiIO& io = ImGui::GetIO();
  io.KeyCtrl = io.KeysDown[GLFW_KEY_LEFT_CONTROL] || io.KeysDown[GLFW_KEY_RIGHT_CONTROL];
  io.KeyShift = io.KeysDown[GLFW_KEY_LEFT_SHIFT] || io.KeysDown[GLFW_KEY_RIGHT_SHIFT];
  io.KeyAlt = io.KeysDown[GLFW_KEY_LEFT_ALT] || io.KeysDown[GLFW_KEY_RIGHT_ALT];
  // A key that came and went within the frame is up again.
  for (int key : std::exchange(inbox_->pressed, {}))
    if (glfwGetKey(window_, key) == GLFW_RELEASE) ImGui::GetIO().KeysDown[key] = false;
}

std::vector<std::string> Window::take_keys() {
  std::vector<std::string> keys;
  std::deque<Inbox::Key>& waiting = inbox_->keys;
  for (; !waiting.empty() && waiting.front().mouse_before <= inbox_->mouse_drawn; waiting.pop_front())
    keys.push_back(std::move(waiting.front().shortcut));
  return keys;
}

std::vector<std::string> Window::take_dropped_files() { return std::exchange(inbox_->dropped, {}); }
double Window::seconds() { return glfwGetTime(); }

}  // namespace weftlight
