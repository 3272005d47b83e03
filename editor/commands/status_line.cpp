#include "commands/status_line.h"

#include <unistd.h>

#include <cstdio>

namespace weftlight::commands {

StatusLine::StatusLine() : terminal_(isatty(STDERR_FILENO) == 1) {}

StatusLine::~StatusLine() { clear(); }

void StatusLine::say(const std::string& what) {
  if (!terminal_) return;
  clear();
  std::fprintf(stderr, "%s", what.c_str());
  std::fflush(stderr);
  width_ = what.size();
}

void StatusLine::clear() {
  if (width_ == 0) return;
  std::fprintf(stderr, "\r%*s\r", static_cast<int>(width_), "");
  std::fflush(stderr);
  width_ = 0;
}

}  // namespace weftlight::commands
