#include "display.h"

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <thread>
#include <utility>

#include "../program.h"
#include "screen.h"

extern char** environ;

namespace weftlight::gui {
namespace {

using namespace std::chrono_literals;
constexpr auto kPatience = 60s;  // on a machine that is busy with other things
constexpr auto kPause = 20ms;
constexpr const char* kPauseS = "0.005";  // between move, press and release

std::string output_of(const std::string& command) {
  std::string text;
  FILE* pipe = popen(command.c_str(), "r");
  if (pipe == nullptr) return text;
  char buffer[65536];
  for (size_t n; (n = fread(buffer, 1, sizeof buffer, pipe)) > 0;) text.append(buffer, n);
  pclose(pipe);
  return text;
}

bool is_installed(const std::string& program) { return !output_of("command -v " + program).empty(); }

std::vector<char*> pointers(std::vector<std::string>& words) {
  std::vector<char*> out;
  for (std::string& word : words) out.push_back(word.data());
  out.push_back(nullptr);
  return out;
}

std::string pause() { return std::string(" sleep ").append(kPauseS).append(" "); }

}  // namespace

std::string why_not() {
  for (const char* program : {"Xvfb", "xdotool"})
    if (!is_installed(program)) return std::string(program) + " is not installed (packages xvfb, xdotool)";
  return {};
}

bool comes_true(const std::function<bool()>& holds) {
  const auto end = std::chrono::steady_clock::now() + kPatience;
  while (!holds()) {
    if (std::chrono::steady_clock::now() > end) return false;
    std::this_thread::sleep_for(kPause);
  }
  return true;
}

std::string bytes_of(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

Process::Process(std::vector<std::string> words, std::vector<std::string> environment, int print_fd,
                 const std::string& errors) {
  for (char** variable = environ; *variable != nullptr; ++variable) environment.push_back(*variable);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  if (print_fd >= 0) posix_spawn_file_actions_adddup2(&actions, print_fd, print_fd);
  if (!errors.empty())
    posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, errors.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  auto argv = pointers(words), env = pointers(environment);
  if (posix_spawnp(&id_, argv[0], &actions, nullptr, argv.data(), env.data()) != 0) id_ = 0;
  posix_spawn_file_actions_destroy(&actions);
}

Process::~Process() {
  if (!is_running()) return;
  kill(id_, SIGTERM);
  waitpid(id_, nullptr, 0);
}

Process& Process::operator=(Process&& other) noexcept {
  std::swap(id_, other.id_);
  std::swap(status_, other.status_);
  return *this;
}

bool Process::is_running() {
  if (id_ == 0) return false;
  int status = 0;
  if (waitpid(id_, &status, WNOHANG) == 0) return true;
  status_ = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  id_ = 0;
  return false;
}

void Process::kill_now() {
  if (id_ != 0) kill(id_, SIGKILL);
}

void Process::send(int signal) {
  if (id_ != 0) kill(id_, signal);
}

int Process::wait() {
  comes_true([this] { return !is_running(); });
  return status_;
}

Display::Display(int width, int height) {
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) return;
  const std::string screen = std::to_string(width) + "x" + std::to_string(height) + "x24";
  // -noreset: otherwise the server begins anew when its last client leaves, and drops one that comes just then.
  server_ =
      Process({"Xvfb", "-displayfd", std::to_string(ends[1]), "-screen", "0", screen, "-nolisten", "tcp", "-noreset"},
              {}, ends[1]);
  close(ends[1]);
  // Xvfb writes the number and its newline separately, and exits if nobody reads the second.
  std::string number;
  for (char c; read(ends[0], &c, 1) == 1 && c != '\n';) number += c;
  close(ends[0]);
  if (!number.empty()) name_ = std::string(":").append(number);
}

std::string Display::hand(const std::string& words) const {
  std::string said = output_of("DISPLAY=" + name_ + " xdotool " + words + " 2>/dev/null");
  wait_for_windows(name_);
  return said;
}

Point Display::on_screen(Point p) const {
  // One that has drawn may not be on the screen yet.
  static constexpr std::chrono::seconds kComes{2};
  const auto end = std::chrono::steady_clock::now() + kComes;
  auto corner = corner_of_window(name_);
  for (; !corner && std::chrono::steady_clock::now() < end; corner = corner_of_window(name_))
    std::this_thread::sleep_for(kPause);
  const auto [x, y] = corner.value_or(std::pair(0, 0));
  return {p.x + x, p.y + y};
}

std::string Display::at(Point p) const {
  const Point to = on_screen(p);
  return std::to_string(std::lround(to.x)) + " " + std::to_string(std::lround(to.y));
}

void Display::move(Point to) const { hand("mousemove " + at(to)); }

void Display::click(Point where) const { drag({where}); }

void Display::drag(const std::vector<Point>& along, const std::string& then) const {
  std::string words = "mousemove " + at(along.front()) + pause() + "mousedown 1" + pause();
  for (const Point& p : along) words += "mousemove " + at(p) + pause();
  if (!then.empty()) words += then + pause();
  hand(words + "mouseup 1" + pause());
}

void Display::drag_holding(const std::string& key, const std::vector<Point>& along) const {
  hand("keydown " + key + pause());
  drag(along);
  hand("keyup " + key + pause());
}

void Display::middle_click(Point where) const { hand("mousemove " + at(where) + pause() + "click 2" + pause()); }

void Display::right_click(Point where) const { hand("mousemove " + at(where) + pause() + "click 3" + pause()); }

void Display::click_holding(const std::string& key, Point where) const {
  hand("mousemove " + at(where) + pause() + "keydown " + key + pause() + "click 1" + pause() + "keyup " + key +
       pause());
}

void Display::focus() const { hand("windowfocus 1 sleep 0.2 search --onlyvisible --class weftlight windowfocus"); }

void Display::type(const std::string& text) const { hand("type --delay 5 '" + text + "'"); }

void Display::key(const std::string& keys) const { hand("key --clearmodifiers --delay 5 " + keys); }

void Display::resize(int width, int height) const {
  hand("search --onlyvisible --class weftlight windowsize " + std::to_string(width) + " " + std::to_string(height));
}

std::string Display::picture(Point where, Point size) const {
  const auto whole = [](double v) { return static_cast<int>(std::lround(v)); };
  const Point corner = on_screen(where);
  return screen_part(name_, whole(corner.x), whole(corner.y), whole(size.x), whole(size.y));
}

Window::Window(const Display& display, const std::filesystem::path& folder, const std::filesystem::path& draft,
               const std::vector<std::string>& more, const std::string& errors,
               const std::vector<std::filesystem::path>& others)
    : map_(folder / "map.json"), live_(folder / "live.wif") {
  std::filesystem::remove(map_);
  std::filesystem::remove(live_);
  const std::string own = folder.string();
  std::vector<std::string> words{tested_program(), "--ui-map", map_.string(), "--live-export", live_.string()};
  if (!draft.empty()) words.push_back(draft.string());
  for (const std::filesystem::path& other : others) words.push_back(other.string());
  std::vector<std::string> environment = more;  // the first entry of a name counts
  for (const std::string& variable :
       {"DISPLAY=" + display.name(), std::string("WAYLAND_DISPLAY="), "HOME=" + own, "XDG_STATE_HOME=" + own + "/state",
        "XDG_CONFIG_HOME=" + own + "/config", "XDG_CACHE_HOME=" + own + "/cache",
        std::string("LIBGL_ALWAYS_SOFTWARE=1"), std::string("WEFTLIGHT_OFFSCREEN=")})
    environment.push_back(variable);
  process_ = Process(std::move(words), std::move(environment), -1, errors);
}

nlohmann::json Window::map() const { return nlohmann::json::parse(bytes_of(map_), nullptr, false); }

int Window::frame() const {
  const nlohmann::json now = map();
  return now.is_object() ? now["frame"].get<int>() : 0;
}

bool Window::is_ready() const { return size_of("threading").first > 0 && !live().empty(); }

Point Window::cell(const std::string& name, int a, int b) const {
  const nlohmann::json now = map();
  for (const auto& grid : now["grids"]) {
    if (grid["name"] != name) continue;
    const auto value = [&](int i) {
      return grid["origin"][i].get<double>() + (a - 1) * grid["step_a"][i].get<double>() +
             (b - 1) * grid["step_b"][i].get<double>();
    };
    return {value(0), value(1)};
  }
  return {-1, -1};
}

std::pair<int, int> Window::size_of(const std::string& name) const {
  const nlohmann::json now = map();
  if (now.is_object())
    for (const auto& grid : now["grids"])
      if (grid["name"] == name) return {grid["count_a"].get<int>(), grid["count_b"].get<int>()};
  return {};
}

bool Window::has(const std::string& control) const { return place_of(control).second.x > 0; }

std::pair<Point, Point> Window::place_of(const std::string& name) const {
  const nlohmann::json now = map();
  if (now.is_object())
    for (const auto& control : now["controls"])
      if (control["name"] == name)
        return {{control["x"].get<double>(), control["y"].get<double>()},
                {control["w"].get<double>(), control["h"].get<double>()}};
  return {};
}

std::string Window::name_after(const std::string& prefix) const {
  const nlohmann::json now = map();
  if (now.is_object())
    for (const auto& control : now["controls"])
      if (const std::string name = control["name"]; name.starts_with(prefix)) return name.substr(prefix.size());
  return {};
}

Point Window::middle_of(const std::string& control) const {
  const auto [place, size] = place_of(control);
  return {place.x + size.x / 2, place.y + size.y / 2};
}

}  // namespace weftlight::gui
