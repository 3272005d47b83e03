#include "platform/step_counter.h"

#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <string>

namespace weftlight::platform {
namespace {

constexpr unsigned kTimeoutS = 600;

// The trap flag of the processor raises a signal after every instruction.
volatile int64_t steps_taken = 0;
void count_step(int) { steps_taken = steps_taken + 1; }

#if defined(__x86_64__)
constexpr bool kCanStep = true;
void set_trap_flag() { asm volatile("pushfq\n\torq $0x100, (%%rsp)\n\tpopfq" ::: "memory", "cc"); }
void clear_trap_flag() { asm volatile("pushfq\n\tandq $~0x100, (%%rsp)\n\tpopfq" ::: "memory", "cc"); }
#else
constexpr bool kCanStep = false;
void set_trap_flag() {}
void clear_trap_flag() {}
#endif

bool read_all(int from, void* to, size_t bytes) {
  for (size_t got = 0; got < bytes;) {
    const ssize_t n = ::read(from, static_cast<char*>(to) + got, bytes - got);
    if (n <= 0) return false;
    got += static_cast<size_t>(n);
  }
  return true;
}

bool write_all(int to, const void* from, size_t bytes) {
  for (size_t sent = 0; sent < bytes;) {
    const ssize_t n = ::send(to, static_cast<const char*>(from) + sent, bytes - sent, MSG_NOSIGNAL);
    if (n <= 0) return false;
    sent += static_cast<size_t>(n);
  }
  return true;
}

/// Runs in the other process.
[[noreturn]] void serve(int line, const StepCounter::Work& work) {
  std::signal(SIGTRAP, count_step);
  size_t size = 0;
  while (read_all(line, &size, sizeof size)) {
    std::string request(size, '\0');
    if (!read_all(line, request.data(), size)) break;
    ::alarm(kTimeoutS);  // ends the process if the work hangs
    for (int warm = 0; warm < 2; ++warm)
      if (!work(request)) ::_exit(1);
    steps_taken = 0;
    set_trap_flag();
    work(request);
    clear_trap_flag();
    ::alarm(0);
    const int64_t steps = steps_taken;
    if (!write_all(line, &steps, sizeof steps)) break;
  }
  ::_exit(0);
}

}  // namespace

std::unique_ptr<StepCounter> StepCounter::start(const Work& work) {
  std::array<int, 2> ends{};
  if (!kCanStep || ::socketpair(AF_UNIX, SOCK_STREAM, 0, ends.data()) != 0) return nullptr;
  const pid_t child = ::fork();
  if (child == 0) {
    ::close(ends[0]);
    serve(ends[1], work);
  }
  ::close(ends[1]);
  std::unique_ptr<StepCounter> counter(new StepCounter);
  counter->process_ = child, counter->line_ = ends[0];
  return child < 0 ? nullptr : std::move(counter);
}

StepCounter::~StepCounter() {
  ::close(static_cast<int>(line_));
  if (process_ <= 0) return;
  ::kill(static_cast<pid_t>(process_), SIGKILL);
  ::waitpid(static_cast<pid_t>(process_), nullptr, 0);
}

std::optional<int64_t> StepCounter::count(std::string_view request) {
  const int line = static_cast<int>(line_);
  const size_t size = request.size();
  int64_t steps = 0;
  const bool counted = write_all(line, &size, sizeof size) && write_all(line, request.data(), size) &&
                       read_all(line, &steps, sizeof steps);
  return counted ? std::optional(steps) : std::nullopt;
}

}  // namespace weftlight::platform
