#pragma once
// How much memory a piece of work takes at its peak.

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <functional>
#include <string>

namespace weftlight {

inline constexpr unsigned kPatienceS = 60;  // a reader that hangs ends here; none is timed

inline long peak_kb() {
  rusage used{};
  getrusage(RUSAGE_SELF, &used);
  return used.ru_maxrss;
}

/// What `read` says, and how much more memory it took at its peak than it had at the start. In a process of its own.
struct Taken {
  std::string said;
  long mb = -1;
};
inline Taken taken_by(const std::function<std::string()>& read) {
  int ends[2];
  if (pipe(ends) != 0) return {};
  const pid_t child = fork();
  if (child == 0) {
    alarm(kPatienceS);
    const long before = peak_kb();
    const std::string said = read();
    const std::string line = std::to_string((peak_kb() - before) / 1024) + " " + said.substr(0, 2000);
    _exit(::write(ends[1], line.data(), line.size()) < 0 ? 1 : 0);
  }
  close(ends[1]);
  std::string line;
  char buffer[4096];
  for (ssize_t n = 0; (n = ::read(ends[0], buffer, sizeof buffer)) > 0;) line.append(buffer, static_cast<size_t>(n));
  close(ends[0]);
  int status = 0;
  waitpid(child, &status, 0);
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) return {"it hung, or was killed", -1};
  return {line.substr(line.find(' ') + 1), std::stol(line)};
}

}  // namespace weftlight
