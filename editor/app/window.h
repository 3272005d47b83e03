#pragma once
// The window with an OpenGL 3.3 core context and ImGui. It sleeps until an event comes.

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "gl/reset_watch.h"
#include "session/editing/true_distance.h"
#include "ui/redraw.h"
#include "ui/style.h"

struct GLFWwindow;
struct GLFWcursor;

namespace weftlight::gl {
class WindowSystem;
}

namespace weftlight::app {

using ui::Style;

class Window {
 public:
  /// Null with `error` set without a display or without OpenGL 3.3.
  static base::Result<std::unique_ptr<Window>> open(int width, int height);
  ~Window();
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;

  /// `lost` is called where the window system goes away, or the driver drops the window's context, on any thread and in
  /// the middle of any of these functions. It ends the program, and calls none of them.
  static void when_lost(std::function<void()> lost);

  /// Sleeps up to `seconds` (negative: until an event); true if there was an event.
  bool wait(double seconds);
  bool wants_close() const;
  void set_wants_close(bool close);
  void set_title(const std::string& title);
  void hide();

  /// Updates fonts and the style of ImGui after the theme, the display scale or the user's own size changed; that is in
  /// percent of what the screen asks for.
  void use_style(Style& style, int percent);
  /// False while a browser has taken the window's GL context. All that ImGui draws with is made anew when it is back;
  /// the rest is the business of its owners.
  bool can_draw();
  void begin_frame();
  void end_frame(ImU32 background);
  /// Ends a frame without drawing it.
  static void drop_frame();

  /// Keys pressed in this frame, written as shortcuts: "Ctrl+Shift+S".
  std::vector<std::string> take_keys();
  std::vector<std::string> take_dropped_files();
  /// Shows a crosshair pointer, or the one that ImGui requests.
  void use_crosshair(bool on);
  /// True once after the window got the keyboard focus.
  bool take_focus();
  /// True if input waits for the next frame.
  bool has_input() const;
  /// True once after something was to be pasted, and the program that holds the clipboard did not answer.
  bool take_silent_clipboard();
  /// Framebuffer pixels per window unit (2 on a Retina display, else 1).
  float pixel_ratio() const;
  /// The screen that has the middle of the window.
  session::Screen screen() const;
  /// Size in window units.
  void size(int& width, int& height) const;
  static double seconds();
  /// Makes wait() return; callable from any thread.
  static void wake();

 private:
  Window();
  float display_scale() const;

  std::shared_ptr<gl::WindowSystem> system_;  // outlives the window
  GLFWwindow* window_ = nullptr;
  struct Inbox;
  static void listen(GLFWwindow* window);
  /// Copies and pastes through the window.
  void give_clipboard();
  const char* pasted();
  /// Passes the mouse and key events of this frame to ImGui.
  void give_input();

  std::unique_ptr<Inbox> inbox_;
  std::unique_ptr<ui::Redraw> redraw_;
  std::optional<gl::ResetWatch> watch_;
  std::string copied_, pasted_;  // texts: of this program, and the last one of any
  bool silent_clipboard_ = false;
  float fonts_for_ = 0;
  GLFWcursor* crosshair_ = nullptr;
};

}  // namespace weftlight::app
