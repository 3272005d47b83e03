#include "platform/stop_request.h"

#include <windows.h>

#include <atomic>
#include <cstdlib>

namespace weftlight::platform {

namespace {

constexpr int kEndedByCtrlC = static_cast<int>(STATUS_CONTROL_C_EXIT);

std::atomic<bool> asked = false;

std::stop_source& source() {
  static std::stop_source& kept = *new std::stop_source;  // the system's thread outlives main()
  return kept;
}

/// On a thread of the system's own.
BOOL WINAPI on_request(DWORD /*kind*/) {
  if (asked.exchange(true)) return FALSE;  // the second one ends the program
  source().request_stop();
  return TRUE;
}

}  // namespace

std::stop_token stop_when_asked() {
  static const bool watched = ::SetConsoleCtrlHandler(on_request, TRUE) != 0;
  static_cast<void>(watched);
  return source().get_token();
}

void end_as_asked() {
  if (asked) std::exit(kEndedByCtrlC);
}

}  // namespace weftlight::platform
