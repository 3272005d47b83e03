#include "commands/status_line.h"

#include <cstdio>

#include "platform/environment_variables.h"

namespace weftlight::commands {

StatusLine::StatusLine() : terminal_(platform::errors_go_to_terminal()) {}

StatusLine::~StatusLine() { clear(); }

void StatusLine::show(const std::string& text) {
  if (!terminal_) return;
  clear();
  std::fprintf(stderr, "%s", text.c_str());
  std::fflush(stderr);
  width_ = text.size();
}

void StatusLine::silence() {
  clear();
  terminal_ = false;
}

void StatusLine::clear() {
  if (width_ == 0) return;
  std::fprintf(stderr, "\r%*s\r", static_cast<int>(width_), "");
  std::fflush(stderr);
  width_ = 0;
}

}  // namespace weftlight::commands
