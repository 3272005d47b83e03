#pragma once
// The system's window with an OpenGL 3.3 core context and ImGui in it. It sleeps until something happens.

#include <memory>
#include <string>
#include <vector>

#include "app/names.h"
#include "ui/redraw.h"
#include "ui/style.h"

struct GLFWwindow;
struct GLFWcursor;

namespace weftlight::app {

class Window {
 public:
  /// Null with `error` set without a display or without OpenGL 3.3.
  static std::unique_ptr<Window> open(int width, int height, std::string& error);
  ~Window();
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;

  /// Sleeps up to `seconds` (negative: as long as nothing happens); true when something happened.
  bool wait(double seconds);
  bool wants_close() const;
  void set_wants_close(bool close);
  void set_title(const std::string& title);

  /// Fonts and ImGui's style anew when the theme or the display's scale changed.
  void use_style(Style& style);
  void begin_frame();
  void end_frame(ImU32 background);
  /// Ends a frame that nobody sees.
  static void drop_frame();

  /// Keys pressed in this frame, as shortcuts are written: "Ctrl+Shift+S".
  std::vector<std::string> take_keys();
  std::vector<std::string> take_dropped_files();
  /// The pointer is a cross that draws rectangles, else what ImGui asks for.
  void use_crosshair(bool on);
  /// True once after the window got the keys again.
  bool take_focus();
  /// Something that the hand did waits for the next frame.
  bool has_input() const;
  /// Framebuffer pixels a window unit (2 on a Retina display, else 1).
  float pixel_ratio() const;
  /// Size in window units.
  void size(int& width, int& height) const;
  static double seconds();
  /// From any thread: wait() returns.
  static void wake();

 private:
  Window();
  float display_scale() const;

  GLFWwindow* window_ = nullptr;
  struct Inbox;
  static void listen(GLFWwindow* window);
  /// Hands ImGui what this frame is to see of the mouse and the keys.
  void give_input();

  std::unique_ptr<Inbox> inbox_;
  std::unique_ptr<ui::Redraw> redraw_;
  float fonts_for_ = 0;
  GLFWcursor* crosshair_ = nullptr;
};

}  // namespace weftlight::app
