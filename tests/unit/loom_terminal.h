#pragma once
// A loom at a serial line of this machine: a pseudo-terminal under a name of its own, which can be pulled out and put
// in again.

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <string>
#include <string_view>

namespace weftlight {

class LoomTerminal {
 public:
  /// `name`: where the port is found.
  explicit LoomTerminal(std::string name) : name_(std::move(name)) { plug_in(); }
  ~LoomTerminal() { pull_out(); }
  LoomTerminal(const LoomTerminal&) = delete;
  LoomTerminal& operator=(const LoomTerminal&) = delete;

  std::string address() const { return "serial:" + name_; }
  bool is_there() const { return loom_ >= 0; }
  void plug_in() {
    loom_ = ::posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC);
    if (loom_ < 0 || ::grantpt(loom_) != 0 || ::unlockpt(loom_) != 0) return pull_out();
    char port[128];
    if (::ptsname_r(loom_, port, sizeof port) != 0) return pull_out();
    std::error_code error;
    std::filesystem::remove(name_, error);
    std::filesystem::create_symlink(port, name_, error);
  }
  void pull_out() {
    if (loom_ >= 0) ::close(loom_);
    loom_ = -1;
  }
  void say(std::string_view words) const { (void)!::write(loom_, words.data(), words.size()); }
  /// What is heard up to a line's end; what came of it within five seconds where there is none.
  std::string heard() const {
    std::string line;
    pollfd waits{loom_, POLLIN, 0};
    for (char c; ::poll(&waits, 1, 5000) > 0 && ::read(loom_, &c, 1) == 1 && c != '\n';) line += c;
    return line;
  }

 private:
  std::string name_;
  int loom_ = -1;
};

}  // namespace weftlight
