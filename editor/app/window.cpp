#include "app/window.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <iterator>
#include <optional>
#include <utility>

#include "base/text.h"
#include "gl/window_system.h"
#include "opengl/opengl.h"
#include "platform/clipboard.h"
#include "platform/display.h"
#include "platform/opened_files.h"
#include "platform/page.h"
#include "session/jobs/input_queue.h"
#include "ui/fonts.h"
#include "ui/imgui_compat.h"
#include "ui/pixel_texture.h"

namespace weftlight::app {

using base::arg, base::fill, base::tr;
using session::InputEvent, session::InputQueue, session::Modifiers;
using ui::apply, ui::dark_colors, ui::feed_button, ui::feed_key, ui::feed_modifiers, ui::feed_pointer, ui::feed_wheel,
    ui::feed_whole_frames, ui::light_colors, ui::load_fonts, ui::use_clipboard;

namespace {

using Kind = InputEvent::Kind;

constexpr int kButtons = IM_ARRAYSIZE(ImGuiIO::MouseDown), kKeys = GLFW_KEY_LAST + 1;
constexpr float kOutside = -1e6f;  // pointer position outside of the window

constexpr std::pair<int, const char*> kNamedKeys[] = {{GLFW_KEY_KP_ADD, "+"},
                                                      {GLFW_KEY_KP_SUBTRACT, "-"},
                                                      {GLFW_KEY_LEFT, "Left"},
                                                      {GLFW_KEY_RIGHT, "Right"},
                                                      {GLFW_KEY_UP, "Up"},
                                                      {GLFW_KEY_DOWN, "Down"},
                                                      {GLFW_KEY_DELETE, "Delete"},
                                                      {GLFW_KEY_BACKSPACE, "Delete"},
                                                      {GLFW_KEY_INSERT, "Insert"},
                                                      {GLFW_KEY_HOME, "Home"},
                                                      {GLFW_KEY_END, "End"},
                                                      {GLFW_KEY_PAGE_UP, "PageUp"},
                                                      {GLFW_KEY_PAGE_DOWN, "PageDown"},
                                                      {GLFW_KEY_ENTER, "Enter"},
                                                      {GLFW_KEY_KP_ENTER, "Enter"},
                                                      {GLFW_KEY_ESCAPE, "Escape"},
                                                      {GLFW_KEY_SPACE, "Space"},
                                                      {GLFW_KEY_TAB, "Tab"}};

std::string key_name(int key, int scancode) {
  if (key >= GLFW_KEY_F1 && key <= GLFW_KEY_F12) return std::string("F").append(std::to_string(key - GLFW_KEY_F1 + 1));
  for (const auto& [named, name] : kNamedKeys)
    if (key == named) return name;
  // The letter on the key in the present keyboard layout.
  const char* name = glfwGetKeyName(key, scancode);
  if (name == nullptr) return {};
  std::string text = name;
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return text == "=" ? "+" : text;
}

Modifiers modifiers(int mods) {
  return {(mods & GLFW_MOD_CONTROL) != 0, (mods & GLFW_MOD_SHIFT) != 0, (mods & GLFW_MOD_ALT) != 0};
}

/// The modifiers whose keys are set in `down`.
Modifiers modifiers(const bool* down) {
  const auto either = [down](int left, int right) { return down[left] || down[right]; };
  return {either(GLFW_KEY_LEFT_CONTROL, GLFW_KEY_RIGHT_CONTROL), either(GLFW_KEY_LEFT_SHIFT, GLFW_KEY_RIGHT_SHIFT),
          either(GLFW_KEY_LEFT_ALT, GLFW_KEY_RIGHT_ALT)};
}

bool is_modifier(int key) { return key >= GLFW_KEY_LEFT_SHIFT && key <= GLFW_KEY_RIGHT_SUPER; }

std::string shortcut(int key, int scancode, int mods) {
  const std::string name = key_name(key, scancode);
  if (name.empty()) return {};
  // Where the system has a Command key (macOS, as ImGui knows), that is the key of shortcuts.
  const bool control = (mods & (ImGui::GetIO().ConfigMacOSXBehaviors ? GLFW_MOD_SUPER : GLFW_MOD_CONTROL)) != 0;
  const bool sign = name == "+";  // typed with Shift on some layouts
  return (control ? "Ctrl+" : "") + std::string((mods & GLFW_MOD_SHIFT) && !sign ? "Shift+" : "") +
         ((mods & GLFW_MOD_ALT) ? "Alt+" : "") + name;
}

/// Newer versions of ImGui manage their textures themselves.
void renew_font_texture() {
#if IMGUI_VERSION_NUM < 19200
  ImGui_ImplOpenGL3_DestroyFontsTexture();
  ImGui_ImplOpenGL3_CreateFontsTexture();
#endif
}

GLFWwindow* make_window(int width, int height) {
  glfwDefaultWindowHints();
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
  glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
  glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
  glfwWindowHint(GLFW_CONTEXT_ROBUSTNESS, GLFW_LOSE_CONTEXT_ON_RESET);
  glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
  glfwWindowHintString(GLFW_X11_CLASS_NAME, "weftlight");
  glfwWindowHintString(GLFW_X11_INSTANCE_NAME, "weftlight");
  return glfwCreateWindow(width, height, "Weftlight", nullptr, nullptr);
}

/// Limits the window to the screen.
void fit_to_screen(GLFWwindow* window) {
  GLFWmonitor* screen = glfwGetPrimaryMonitor();
  if (screen == nullptr) return;
  int x, y, room_x, room_y, width, height;
  glfwGetMonitorWorkarea(screen, &x, &y, &room_x, &room_y);
  glfwGetWindowSize(window, &width, &height);
  if (room_x > 0 && room_y > 0 && (width > room_x || height > room_y))
    glfwSetWindowSize(window, std::min(width, room_x), std::min(height, room_y));
}

}  // namespace

struct Window::Inbox {
  bool happened = true, exposed = true, focused = false;
  InputQueue input;
  std::vector<std::string> dropped;
  std::vector<std::string> shortcuts;                     // of the frame
  bool key_of_character = false;                          // the last shortcut may type the next character
  bool alt_alone = false;                                 // Alt is down, and nothing else was pressed since
  bool button_down[kButtons] = {}, key_down[kKeys] = {};  // as last reported by the window system
  double x = kOutside, y = kOutside;                      // position of the last move
  ImVec2 given_pointer = {kOutside, kOutside};            // as passed to ImGui
  bool given_buttons[kButtons] = {}, given_keys[kKeys] = {};

  static Inbox& of(GLFWwindow* w) {
    Inbox& in = *static_cast<Inbox*>(glfwGetWindowUserPointer(w));
    in.happened = true;
    return in;
  }
  bool dragging() const {
    return std::find(std::begin(button_down), std::end(button_down), true) != std::end(button_down);
  }
  void key(int key, int scancode, int action, int mods);
  /// Passes an event to ImGui.
  void give(InputEvent& e);
};

void Window::Inbox::key(int key, int scancode, int action, int mods) {
  const bool down = action != GLFW_RELEASE;
  if (key < 0 || key >= kKeys) return;
  key_down[key] = down;
  InputEvent e{
      is_modifier(key) ? Kind::kModifier : Kind::kKey, x, y, static_cast<unsigned>(key), down, modifiers(mods)};
  if (down) e.shortcut = shortcut(key, scancode, mods);
  const bool alt = key == GLFW_KEY_LEFT_ALT;
  if (!down && alt && alt_alone) e.shortcut = "Alt";  // pressed and released alone
  alt_alone = down && alt && (mods & (GLFW_MOD_CONTROL | GLFW_MOD_SHIFT | GLFW_MOD_SUPER)) == 0;
  input.add(std::move(e));
}

// These replace the callbacks of ImGui: the queue keeps the order of events.
void Window::listen(GLFWwindow* w) {
  glfwSetKeyCallback(w, [](GLFWwindow* at, int key, int scancode, int action, int mods) {
    Inbox::of(at).key(key, scancode, action, mods);
  });
  glfwSetCharCallback(w, [](GLFWwindow* at, unsigned code) {
    Inbox& in = Inbox::of(at);
    in.input.add({Kind::kCharacter, in.x, in.y, code});
  });
  glfwSetMouseButtonCallback(w, [](GLFWwindow* at, int button, int action, int mods) {
    Inbox& in = Inbox::of(at);
    if (button < 0 || button >= kButtons) return;
    in.button_down[button] = action == GLFW_PRESS;
    in.alt_alone = false;
    // The position of the last move: glfwGetCursorPos gives the present one, which differs after a slow frame.
    in.input.add({Kind::kButton, in.x, in.y, static_cast<unsigned>(button), action == GLFW_PRESS, modifiers(mods)});
  });
  glfwSetCursorPosCallback(w, [](GLFWwindow* at, double x, double y) {
    Inbox& in = Inbox::of(at);
    in.x = x;
    in.y = y;
    in.input.add({Kind::kMove, x, y});
  });
  glfwSetScrollCallback(w, [](GLFWwindow* at, double x, double y) {
    Inbox& in = Inbox::of(at);
    in.alt_alone = false;
    in.input.add({Kind::kScroll, x, y, 0, false, modifiers(in.key_down)});
  });
  glfwSetCursorEnterCallback(w, [](GLFWwindow* at, int entered) {
    Inbox& in = Inbox::of(at);
    // Outside, nothing is under the pointer; a drag keeps it.
    if (!entered && !in.dragging()) in.input.add({Kind::kMove, kOutside, kOutside});
  });
  glfwSetWindowFocusCallback(w, [](GLFWwindow* at, int focused) {
    Inbox& in = Inbox::of(at);
    in.focused |= focused != 0;
    in.alt_alone = false;  // GLFW releases the keys of a window that loses the keyboard: Alt+Tab
    ImGui_ImplGlfw_WindowFocusCallback(at, focused);
  });
  glfwSetDropCallback(w, [](GLFWwindow* at, int count, const char** paths) {
    std::vector<std::string>& dropped = Inbox::of(at).dropped;
    dropped.insert(dropped.end(), paths, paths + count);  // what waits for the end of a dialog is opened, too
  });
  glfwSetWindowSizeCallback(w, [](GLFWwindow* at, int, int) { Inbox::of(at); });
  glfwSetFramebufferSizeCallback(w, [](GLFWwindow* at, int, int) { Inbox::of(at); });
  glfwSetWindowContentScaleCallback(w, [](GLFWwindow* at, float, float) { Inbox::of(at); });
  glfwSetWindowRefreshCallback(w, [](GLFWwindow* at) { Inbox::of(at).exposed = true; });
  glfwSetWindowCloseCallback(w, [](GLFWwindow* at) { Inbox::of(at); });
}

Window::Window() : inbox_(std::make_unique<Inbox>()) {}

void Window::give_input() {
  std::optional<Modifiers> held;
  inbox_->shortcuts.clear();
  for (InputEvent& e : inbox_->input.next_frame()) {
    inbox_->give(e);
    // The modifiers at the press, even if released since.
    if (e.kind == Kind::kButton || e.kind == Kind::kScroll || (e.kind == Kind::kKey && e.down)) held = e.held;
  }
  const bool* keys = inbox_->given_keys;
  const Modifiers now = held.value_or(modifiers(keys));
  feed_modifiers(now.ctrl, now.shift, now.alt, keys[GLFW_KEY_LEFT_SUPER] || keys[GLFW_KEY_RIGHT_SUPER]);
  feed_pointer(inbox_->given_pointer);
  for (int i = 0; i < kButtons; ++i) feed_button(i, inbox_->given_buttons[i]);
}

void Window::Inbox::give(InputEvent& e) {
  switch (e.kind) {
    case Kind::kButton:
      given_buttons[e.code] = e.down;
      [[fallthrough]];
    case Kind::kMove:
      given_pointer = {static_cast<float>(e.x), static_cast<float>(e.y)};
      break;
    case Kind::kScroll:
      feed_wheel(static_cast<float>(e.x), static_cast<float>(e.y));
      break;
    case Kind::kKey:
      key_of_character = !e.shortcut.empty();
      if (key_of_character) shortcuts.push_back(std::move(e.shortcut));
      [[fallthrough]];
    case Kind::kModifier:
      if (e.kind == Kind::kModifier && !e.shortcut.empty()) shortcuts.push_back(std::move(e.shortcut));
      given_keys[e.code] = e.down;
      feed_key(static_cast<int>(e.code), e.down);
      break;
    case Kind::kCharacter:
      // A digit counts as its key also if the layout needs Shift for it, or on the number pad.
      if (e.code >= '0' && e.code <= '9') {
        if (key_of_character) shortcuts.pop_back();
        shortcuts.emplace_back(1, static_cast<char>(e.code));
      }
      key_of_character = false;
      ImGui::GetIO().AddInputCharacter(e.code);
      break;
  }
}

void Window::use_crosshair(bool on) {
  ImGuiConfigFlags& flags = ImGui::GetIO().ConfigFlags;
  const bool was = flags & ImGuiConfigFlags_NoMouseCursorChange;
  if (on == was) return;
  if (crosshair_ == nullptr) crosshair_ = glfwCreateStandardCursor(GLFW_CROSSHAIR_CURSOR);
  if (on) glfwSetCursor(window_, crosshair_);
  flags = on ? flags | ImGuiConfigFlags_NoMouseCursorChange : flags & ~ImGuiConfigFlags_NoMouseCursorChange;
}

void Window::give_clipboard() {
  use_clipboard({[](void* of) { return static_cast<Window*>(of)->pasted(); },
                 [](void* of, const char* text) {
                   auto& window = *static_cast<Window*>(of);
                   window.copied_ = text;
                   glfwSetClipboardString(window.window_, text);
                 },
                 this});
}

const char* Window::pasted() {
  using State = platform::ClipboardText::State;
  platform::ClipboardText read = platform::clipboard_text(window_);
  silent_clipboard_ |= read.state == State::kSilent;
  switch (read.state) {
    case State::kUnknown:
      return glfwGetClipboardString(window_);
    case State::kOwn:
      return copied_.c_str();
    case State::kNone:
    case State::kSilent:
      return nullptr;
    case State::kText:
      break;
  }
  pasted_ = std::move(read.text);
  return pasted_.c_str();
}

bool Window::take_silent_clipboard() { return std::exchange(silent_clipboard_, false); }

bool Window::take_focus() { return std::exchange(inbox_->focused, false); }

bool Window::has_input() const { return !inbox_->input.empty(); }

base::Result<std::unique_ptr<Window>> Window::open(int width, int height) {
  auto system = gl::WindowSystem::use();
  if (!system)
    return base::failure(base::ErrorKind::kGraphics, fill(tr("the window system cannot be reached ({problem}); without "
                                                             "a display, use the commands: weftlight --help"),
                                                          arg("problem", message(system.error()))));
  std::unique_ptr<Window> w(new Window);
  w->system_ = std::move(*system);
  w->window_ = make_window(width, height);
  if (w->window_ == nullptr)
    return base::failure(
        base::ErrorKind::kGraphics,
        fill(tr("no window with OpenGL 3.3 can be created ({problem}); install or update the graphics driver"),
             arg("problem", gl::WindowSystem::last_problem())));
  fit_to_screen(w->window_);
  glfwMakeContextCurrent(w->window_);
  glfwSwapInterval(1);
  glfwSetWindowUserPointer(w->window_, w->inbox_.get());
  listen(w->window_);
  ImGui::CreateContext();
  ImGui::GetIO().IniFilename = nullptr;
  ImGui::GetIO().ConfigDragClickToInputText = true;
  feed_whole_frames();
  ImGui_ImplGlfw_InitForOpenGL(w->window_, false);
  ImGui_ImplOpenGL3_Init(opengl::kImGuiShaderHead);
  w->give_clipboard();
  w->redraw_ = std::make_unique<ui::Redraw>();
  w->watch_.emplace();
  return w;
}

Window::~Window() {
  if (window_ != nullptr) {
    redraw_.reset();
    if (ImGui::GetCurrentContext() != nullptr) {
      ImGui_ImplOpenGL3_Shutdown();
      ImGui_ImplGlfw_Shutdown();
      ImGui::DestroyContext();
    }
    glfwDestroyWindow(window_);
  }
}

// It stands in core/platform, because a thread of its own may have to call it.
void Window::when_lost(std::function<void()> lost) { platform::when_display_lost(std::move(lost)); }

bool Window::wait(double seconds) {
  if (seconds < 0) glfwWaitEvents();
  else if (seconds == 0) glfwPollEvents();
  else glfwWaitEventsTimeout(seconds);
  if (platform::is_display_lost()) platform::display_lost();
  // Files that the system gives, without an event of the window: a page's links and drops.
  for (std::string& file : platform::take_opened_files()) {
    inbox_->dropped.push_back(std::move(file));
    inbox_->happened = true;
  }
  return std::exchange(inbox_->happened, false);
}

bool Window::wants_close() const { return glfwWindowShouldClose(window_); }
void Window::set_wants_close(bool close) { glfwSetWindowShouldClose(window_, close); }
void Window::set_title(const std::string& title) { glfwSetWindowTitle(window_, title.c_str()); }
void Window::hide() { glfwHideWindow(window_); }

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

session::Screen Window::screen() const {
  int x = 0, y = 0, width = 0, height = 0, count = 0;
  glfwGetWindowPos(window_, &x, &y);  // 0 under Wayland, which does not say
  glfwGetWindowSize(window_, &width, &height);
  GLFWmonitor** const monitors = glfwGetMonitors(&count);
  session::Screen found;
  for (int i = 0; i < count; ++i) {
    int left = 0, top = 0, wide_mm = 0, unused = 0;
    glfwGetMonitorPos(monitors[i], &left, &top);
    glfwGetMonitorPhysicalSize(monitors[i], &wide_mm, &unused);
    const GLFWvidmode* const mode = glfwGetVideoMode(monitors[i]);
    if (mode == nullptr) continue;
    const int right = x + width / 2 - left, down = y + height / 2 - top;
    const bool here = right >= 0 && right < mode->width && down >= 0 && down < mode->height;
    if (!here && !found.name.empty()) continue;
    const char* const name = glfwGetMonitorName(monitors[i]);
    found.name = std::string(name != nullptr ? name : "") + " " + std::to_string(mode->width) + "x" +
                 std::to_string(mode->height);
    found.px_a_mm = wide_mm > 0 ? static_cast<float>(mode->width) / static_cast<float>(wide_mm) : 0.0f;
    if (here) break;
  }
  return found;
}

void Window::size(int& width, int& height) const { glfwGetWindowSize(window_, &width, &height); }

void Window::use_style(Style& style, int percent) {
  constexpr float kSmallest = 0.6f, kLargest = 4;  // of legible letters, and of what a texture of them can hold
  constexpr float kFinger = 44;                    // points
  const float scale = std::clamp(display_scale() * static_cast<float>(percent) / 100, kSmallest, kLargest);
  style.scale = scale / pixel_ratio();
  style.finger = platform::is_touched() ? std::ceil(kFinger * display_scale() / pixel_ratio()) : 0;
  style.color = style.dark ? dark_colors() : light_colors();
  if (fonts_for_ != scale) {
    style.font = load_fonts(scale, pixel_ratio());
    renew_font_texture();
    fonts_for_ = scale;
  }
  apply(style);
  redraw_->invalidate();
}

bool Window::can_draw() {
  if (!watch_->is_lost()) return true;
  if (!watch_->is_back()) return false;
  watch_.emplace();
  redraw_ = std::make_unique<ui::Redraw>();
  // The next frame makes its objects; it remembers the sizes of the old ones.
  ImGui_ImplOpenGL3_Shutdown();
  ImGui_ImplOpenGL3_Init(opengl::kImGuiShaderHead);
  ui::PixelTexture::upload_all();
  inbox_->happened = true;
  return true;
}

void Window::begin_frame() {
  ImGui_ImplOpenGL3_NewFrame();
  ImGui_ImplGlfw_NewFrame();
  give_input();
  ImGui::NewFrame();
}

void Window::end_frame(ImU32 background) {
  ImGui::Render();
  int width = 0, height = 0;
  glfwGetFramebufferSize(window_, &width, &height);
  const bool exposed = std::exchange(inbox_->exposed, false);
  if (redraw_->draw(*ImGui::GetDrawData(), width, height, background, exposed)) glfwSwapBuffers(window_);
  if (watch_->is_lost()) platform::display_lost();
}

void Window::drop_frame() { ImGui::EndFrame(); }

std::vector<std::string> Window::take_keys() { return std::exchange(inbox_->shortcuts, {}); }

std::vector<std::string> Window::take_dropped_files() { return std::exchange(inbox_->dropped, {}); }
double Window::seconds() { return glfwGetTime(); }
void Window::wake() { glfwPostEmptyEvent(); }

}  // namespace weftlight::app
