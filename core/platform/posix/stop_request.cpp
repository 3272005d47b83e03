// A handler of signals may call only what is safe in the middle of anything else: it writes into a pipe, and a thread
// that waits for it makes the request.

#include "platform/stop_request.h"

#include <fcntl.h>
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <thread>

namespace weftlight::platform {

namespace {

constexpr int kRequests[] = {SIGINT, SIGTERM, SIGHUP};

int from_handler[2];          // the pipe: reading end, writing end
std::atomic<int> request{0};  // the signal; 0: none yet
static_assert(std::atomic<int>::is_always_lock_free);

/// The second one ends the program. std::signal is safe here under POSIX.
void on_request(int signal) {
  if (request.exchange(signal) != 0) {
    std::signal(signal, SIG_DFL);
    std::raise(signal);
  }
  // A full pipe is read already.
  [[maybe_unused]] const auto written = ::write(from_handler[1], "", 1);
}

std::stop_source watch_requests() {
  std::stop_source source;
  if (::pipe(from_handler) != 0) return source;
  for (const int end : from_handler) ::fcntl(end, F_SETFD, FD_CLOEXEC);
  std::thread([source]() mutable {
    char byte = 0;
    while (::read(from_handler[0], &byte, 1) < 0) {  // interrupted
    }
    source.request_stop();
  }).detach();
  for (const int each : kRequests) {
    struct sigaction before {};
    ::sigaction(each, nullptr, &before);
    if (before.sa_handler == SIG_IGN) continue;
    struct sigaction action {};
    action.sa_handler = on_request;
    action.sa_flags = SA_RESTART;
    ::sigaction(each, &action, nullptr);
  }
  return source;
}

}  // namespace

std::stop_token stop_when_asked() {
  static const std::stop_source& source = *new std::stop_source(watch_requests());  // the thread outlives main()
  return source.get_token();
}

void end_as_asked() {
  const int signal = request;
  if (signal == 0) return;
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

}  // namespace weftlight::platform
