#pragma once
// How much memory and processor time a piece of work takes.

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <functional>
#include <string>

namespace weftlight {

inline constexpr unsigned kPatienceS = 60;  // a reader that hangs ends here; none is timed

inline long peak_kb() {
  rusage used{};
  getrusage(RUSAGE_SELF, &used);
  return used.ru_maxrss;
}

/// Of all threads of this process.
inline double processor_s() {
  rusage used{};
  getrusage(RUSAGE_SELF, &used);
  const auto seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  return seconds(used.ru_utime) + seconds(used.ru_stime);
}

/// What `read` says, and how much more memory it took at its peak than it had at the start. In a process of its own.
struct Taken {
  std::string said;
  long mb = -1;
  double processor_s = 0;
};
inline Taken taken_by(const std::function<std::string()>& read) {
  int ends[2];
  if (pipe(ends) != 0) return {};
  const pid_t child = fork();
  if (child == 0) {
    alarm(kPatienceS);
    const long before = peak_kb();
    const std::string said = read();
    const std::string line =
        std::to_string((peak_kb() - before) / 1024) + " " + std::to_string(processor_s()) + " " + said.substr(0, 2000);
    _exit(::write(ends[1], line.data(), line.size()) < 0 ? 1 : 0);
  }
  close(ends[1]);
  std::string line;
  char buffer[4096];
  for (ssize_t n = 0; (n = ::read(ends[0], buffer, sizeof buffer)) > 0;) line.append(buffer, static_cast<size_t>(n));
  close(ends[0]);
  int status = 0;
  waitpid(child, &status, 0);
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) return {"it hung, or was killed"};
  const size_t second = line.find(' ') + 1;
  return {line.substr(line.find(' ', second) + 1), std::stol(line), std::stod(line.substr(second))};
}

/// A small file that claims to be large is answered with `wanted` before it takes more than 300 MB and 2 s of the
/// processor, which no other program of the machine can lengthen. Under a sanitizer this was not measured.
inline void expect_harmless(const std::function<std::string()>& read, const std::string& wanted) {
  constexpr long kMaxMb = 300;
  constexpr double kMaxS = 2;
  const Taken taken = taken_by(read);
  EXPECT_NE(taken.said.find(wanted), std::string::npos) << taken.said;
  EXPECT_GE(taken.mb, 0);
  EXPECT_LT(taken.mb, kMaxMb) << taken.said;
  EXPECT_LT(taken.processor_s, kMaxS) << taken.said;
  if (std::getenv("WEFTLIGHT_SHOW_BOMBS") != nullptr)
    std::printf("%5ld MB %6.3f s  %.120s\n", taken.mb, taken.processor_s, taken.said.c_str());
}

}  // namespace weftlight
