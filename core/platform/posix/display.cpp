#include "platform/display.h"

#include <dlfcn.h>
#include <poll.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <mutex>
#include <thread>
#include <utility>

namespace weftlight::platform {
namespace {

/// A function of a library that this program has loaded; null if it has not. The window library loads those of the
/// window system that it finds, so this program links none of them.
template <class Function>
Function* loaded(const char* library, const char* name) {
  void* const there = library == nullptr ? RTLD_DEFAULT : dlopen(library, RTLD_LAZY | RTLD_NOLOAD);
  if (library != nullptr && there == nullptr) return nullptr;
  return reinterpret_cast<Function*>(dlsym(there, name));
}

/// Xlib passes nothing to its handler that could lead to it.
struct Lost {
  std::mutex mutex;
  std::function<void()> handler;
  bool begun = false;
};
Lost& lost_display() {
  static Lost lost;
  return lost;
}

/// The first who calls it ends the program. Were it to return to Xlib, that would run the program's exit while the
/// first is still at work.
void end_once() {
  std::unique_lock lock(lost_display().mutex);
  const std::function<void()> handler = lost_display().handler;
  if (!handler) return;
  const bool first = !std::exchange(lost_display().begun, true);
  lock.unlock();
  if (first) handler();
  for (;;) ::pause();
}

using XHandler = int(void*);  // of an XDisplay

int x_lost(void*) {
  end_once();
  return 0;
}

/// The connection to the compositor; null where there is none. The window library knows it; a build of it for X alone
/// does not have the function.
void* wayland_display() {
  static auto* const display = loaded<void*()>(nullptr, "glfwGetWaylandDisplay");
  return display != nullptr ? display() : nullptr;
}

/// Waits on a thread of its own, since GLFW's wait for events (3.3) never ends after the compositor did.
void watch_compositor() {
  static constexpr std::chrono::seconds kByItself{2};  // for the window's thread to notice it by itself
  auto* const descriptor = loaded<int(void*)>("libwayland-client.so.0", "wl_display_get_fd");
  void* const display = wayland_display();
  if (descriptor == nullptr || display == nullptr) return;
  std::thread([connection = descriptor(display)] {
    pollfd end{connection, 0, 0};
    while (::poll(&end, 1, -1) < 0 && errno == EINTR) {
    }
    std::this_thread::sleep_for(kByItself);
    end_once();
  }).detach();
}

}  // namespace

void when_display_lost(std::function<void()> lost) {
  using SetHandler = XHandler*(XHandler*);
  static auto* const set = loaded<SetHandler>("libX11.so.6", "XSetIOErrorHandler");
  static std::once_flag watched;
  {
    const std::lock_guard lock(lost_display().mutex);
    lost_display().handler = std::move(lost);
  }
  // A write to a server that has gone would end the program before its handler is called.
  std::signal(SIGPIPE, SIG_IGN);
  if (set != nullptr) set(x_lost);
  std::call_once(watched, watch_compositor);
}

bool is_display_lost() {
  static auto* const error = loaded<int(void*)>("libwayland-client.so.0", "wl_display_get_error");
  void* const display = wayland_display();
  return error != nullptr && display != nullptr && error(display) != 0;
}

void display_lost() { end_once(); }

}  // namespace weftlight::platform
