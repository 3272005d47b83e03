#pragma once
// Progress of a slow command on one line of stderr, only if that is a terminal. Each text replaces the one before.

#include <string>

namespace weftlight::commands {

class StatusLine {
 public:
  StatusLine();
  ~StatusLine();
  StatusLine(const StatusLine&) = delete;
  StatusLine& operator=(const StatusLine&) = delete;
  void show(const std::string& text);
  /// Shows nothing from now on.
  void silence();
  void clear();

 private:
  bool terminal_;
  size_t width_ = 0;  // bytes of the text that is shown
};

}  // namespace weftlight::commands
