#pragma once
// A display that nobody sees (Xvfb), with the real window on it, a hand (xdotool) and an eye (ImageMagick).

#include <sys/types.h>

#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace weftlight::gui {

/// Empty, or why the window cannot be driven on this machine.
std::string why_not();

/// Asks again and again until it holds; false when it did not within half a minute.
bool comes_true(const std::function<bool()>& holds);

std::string bytes_of(const std::filesystem::path& path);

class Process {
 public:
  Process() = default;
  /// `environment`: NAME=value, beside that of this process. `print_fd`: handed to the child under its number.
  Process(std::vector<std::string> words, std::vector<std::string> environment = {}, int print_fd = -1);
  ~Process();
  Process(Process&& other) noexcept { *this = std::move(other); }
  Process& operator=(Process&& other) noexcept;
  bool is_running();
  /// As kill -9 does.
  void kill_now();
  pid_t id() const { return id_; }
  /// Waits for its end; the exit status, or -1 when it was killed or does not end.
  int wait();

 private:
  pid_t id_ = 0;
  int status_ = -1;
};

struct Point {
  double x = 0, y = 0;
};

class Display {
 public:
  Display(int width, int height);
  bool is_up() const { return !name_.empty(); }
  const std::string& name() const { return name_; }
  void move(Point to) const;
  void click(Point at) const;
  void middle_click(Point at) const;
  void right_click(Point at) const;
  /// `then`: what the hand does before it lets go, as xdotool writes it: "key Escape".
  void drag(const std::vector<Point>& along, const std::string& then = {}) const;
  /// With a key held down until after the button is let go.
  void drag_holding(const std::string& key, const std::vector<Point>& along) const;
  /// With a key held down: "shift", "ctrl".
  void click_holding(const std::string& key, Point at) const;
  void key(const std::string& keys) const;
  void type(const std::string& text) const;
  /// The window gets the keys, as when a weaver comes back to it.
  void focus() const;
  /// The window, in pixels; waits until it has drawn itself.
  void resize(int width, int height) const;
  /// Pixels of a rectangle, as a PPM's bytes.
  std::string picture(Point at, Point size) const;

 private:
  std::string hand(const std::string& words) const;
  std::string name_;
  Process server_;
};

/// The window with its --ui-map and --live-export.
class Window {
 public:
  /// `draft` empty: none is opened. `more`: NAME=value of the environment.
  Window(const Display& display, const std::filesystem::path& folder, const std::filesystem::path& draft,
         const std::vector<std::string>& more = {});
  bool is_ready() const;
  /// Middle of a cell of a grid; both from 1.
  Point cell(const std::string& grid, int a, int b) const;
  /// Columns and rows of a grid, as they were last drawn.
  std::pair<int, int> size_of(const std::string& grid) const;
  bool has(const std::string& control) const;
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
