#include "chart/counter.h"

#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstdlib>
#include <type_traits>

namespace weftlight::chart {
namespace {

constexpr int kSmall = 4, kLarge = 12;  // pixels along the sides of the two patches
constexpr unsigned kTimeoutS = 600;

static_assert(std::is_trivially_copyable_v<CountedDraw> && std::is_trivially_copyable_v<LodPoint>);

// The trap flag of the processor raises a signal after every instruction.
volatile long steps_taken = 0;
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
    const ssize_t n = read(from, static_cast<char*>(to) + got, bytes - got);
    if (n <= 0) return false;
    got += static_cast<size_t>(n);
  }
  return true;
}

bool write_all(int to, const void* from, size_t bytes) {
  for (size_t sent = 0; sent < bytes;) {
    const ssize_t n = send(to, static_cast<const char*>(from) + sent, bytes - sent, MSG_NOSIGNAL);
    if (n <= 0) return false;
    sent += static_cast<size_t>(n);
  }
  return true;
}

/// Runs in the other process. Each patch is drawn before it is counted, so that programs are compiled and pages mapped.
[[noreturn]] void serve(int socket, const DrawCounter::Draw& draw) {
  setenv("LP_NUM_THREADS", "0", 1);
  setenv("LIBGL_ALWAYS_SOFTWARE", "1", 1);
  std::signal(SIGTRAP, count_step);
  CountedDraw what;
  size_t points = 0;
  while (read_all(socket, &what, sizeof what) && read_all(socket, &points, sizeof points)) {
    LodTable lod_table(points);
    if (!read_all(socket, lod_table.data(), points * sizeof(LodPoint))) break;
    alarm(kTimeoutS);  // ends the process if a draw hangs
    std::array<long, 2> steps{};
    for (size_t k = 0; k < steps.size(); ++k) {
      const int pixels = k == 0 ? kSmall : kLarge;
      for (int warm = 0; warm < 2; ++warm)
        if (!draw(what, lod_table, pixels)) _exit(1);
      steps_taken = 0;
      set_trap_flag();
      draw(what, lod_table, pixels);
      clear_trap_flag();
      steps[k] = steps_taken;
    }
    alarm(0);
    if (!write_all(socket, steps.data(), sizeof steps)) break;
  }
  _exit(0);
}

}  // namespace

std::unique_ptr<DrawCounter> DrawCounter::start(const Draw& draw) {
  std::array<int, 2> ends{};
  if (!kCanStep || socketpair(AF_UNIX, SOCK_STREAM, 0, ends.data()) != 0) return nullptr;
  const pid_t child = fork();
  if (child == 0) {
    close(ends[0]);
    serve(ends[1], draw);
  }
  close(ends[1]);
  std::unique_ptr<DrawCounter> counter(new DrawCounter);
  counter->child_ = child, counter->socket_ = ends[0];
  return child < 0 ? nullptr : std::move(counter);
}

DrawCounter::~DrawCounter() {
  close(socket_);
  if (child_ < 0) return;
  kill(child_, SIGKILL);
  waitpid(child_, nullptr, 0);
}

std::optional<double> DrawCounter::per_pixel(const CountedDraw& what, const LodTable& lod_table) {
  const size_t points = lod_table.size();
  std::array<long, 2> steps{};
  const bool counted = write_all(socket_, &what, sizeof what) && write_all(socket_, &points, sizeof points) &&
                       write_all(socket_, lod_table.data(), points * sizeof(LodPoint)) &&
                       read_all(socket_, steps.data(), sizeof steps);
  if (!counted) return std::nullopt;
  return static_cast<double>(steps[1] - steps[0]) / (kLarge * kLarge - kSmall * kSmall);
}

}  // namespace weftlight::chart
