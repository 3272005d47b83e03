#pragma once
// What a slow command is at, on a terminal alone: one line that each word replaces and the end takes away.

#include <string>

namespace weftlight::commands {

class StatusLine {
 public:
  StatusLine();
  ~StatusLine();
  StatusLine(const StatusLine&) = delete;
  StatusLine& operator=(const StatusLine&) = delete;
  void say(const std::string& what);
  void clear();

 private:
  bool terminal_;
  size_t width_ = 0;  // of what stands there
};

}  // namespace weftlight::commands
