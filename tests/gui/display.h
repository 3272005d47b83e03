#pragma once
// A virtual display (Xvfb) with the real window on it, driven by xdotool.

#include <sys/types.h>

#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace weftlight::gui {

/// Empty, or the reason why these tests cannot run on this machine.
std::string why_not();

/// Polls until the condition holds. False if it does not within a minute.
bool comes_true(const std::function<bool()>& holds);

std::string bytes_of(const std::filesystem::path& path);

class Process {
 public:
  Process() = default;
  /// `environment`: NAME=value, added to that of this process. `print_fd`: passed to the child with the same number.
  /// `errors`: file of its standard error; empty: that of this process.
  Process(std::vector<std::string> words, std::vector<std::string> environment = {}, int print_fd = -1,
          const std::string& errors = {});
  ~Process();
  Process(Process&& other) noexcept { *this = std::move(other); }
  Process& operator=(Process&& other) noexcept;
  bool is_running();
  /// Like kill -9.
  void kill_now();
  void send(int signal);
  pid_t id() const { return id_; }
  /// Waits for it to exit. Returns the exit status, or -1 if it was killed or does not exit.
  int wait();

 private:
  pid_t id_ = 0;
  int status_ = -1;
};

struct Point {
  double x = 0, y = 0;
};

/// What it does with pointer and keys returns once the window has taken it and drawn what came of it.
class Display {
 public:
  Display(int width, int height);
  bool is_up() const { return !name_.empty(); }
  /// The server goes away under its windows.
  void kill_now() { server_.kill_now(); }
  const std::string& name() const { return name_; }
  void move(Point to) const;
  void click(Point at) const;
  void middle_click(Point at) const;
  void right_click(Point at) const;
  /// `then`: xdotool commands before the button is released: "key Escape".
  void drag(const std::vector<Point>& along, const std::string& then = {}) const;
  /// With a key held until after the button is released.
  void drag_holding(const std::string& key, const std::vector<Point>& along) const;
  /// With a key held: "shift", "ctrl".
  void click_holding(const std::string& key, Point at) const;
  void key(const std::string& keys) const;
  void type(const std::string& text) const;
  /// On the screen, of a point of the window: Wine leaves room for a frame.
  Point on_screen(Point p) const;
  /// Gives the window the keyboard focus.
  void focus() const;
  void resize(int width, int height) const;
  /// The pixels of a rectangle, as a PPM file.
  std::string picture(Point at, Point size) const;

 private:
  std::string hand(const std::string& words) const;
  std::string at(Point p) const;
  std::string name_;
  Process server_;
};

/// The window with its --ui-map and --live-export.
class Window {
 public:
  /// `draft`: empty to open none. `more`: NAME=value for the environment. `errors`: file of its standard error.
  /// `others`: files to open after the draft.
  Window(const Display& display, const std::filesystem::path& folder, const std::filesystem::path& draft,
         const std::vector<std::string>& more = {}, const std::string& errors = {},
         const std::vector<std::filesystem::path>& others = {});
  bool is_ready() const;
  /// The number of the frame that last changed the layout.
  int frame() const;
  /// Centre of a cell of a grid, both counted from 1.
  Point cell(const std::string& grid, int a, int b) const;
  /// Columns and rows of a grid, as they were last drawn.
  std::pair<int, int> size_of(const std::string& grid) const;
  bool has(const std::string& control) const;
  /// The rest of the first name that begins so; empty if there is none.
  std::string name_after(const std::string& prefix) const;
  Point middle_of(const std::string& control) const;
  /// Position and size of a control.
  std::pair<Point, Point> place_of(const std::string& control) const;
  std::string live() const { return bytes_of(live_); }
  Process& process() { return process_; }

 private:
  nlohmann::json map() const;
  std::filesystem::path map_, live_;
  Process process_;
};

}  // namespace weftlight::gui
