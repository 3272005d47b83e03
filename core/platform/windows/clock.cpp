#include "platform/clock.h"

#include <windows.h>

#include <ctime>

namespace weftlight::platform {

std::tm local_time(int64_t seconds) {
  const std::time_t at = seconds;
  std::tm parts{};
  ::localtime_s(&parts, &at);
  return parts;
}

std::tm utc_time(int64_t seconds) {
  const std::time_t at = seconds;
  std::tm parts{};
  ::gmtime_s(&parts, &at);
  return parts;
}

double processor_ns() {
  FILETIME begun{}, ended{}, system{}, own{};
  if (::GetProcessTimes(::GetCurrentProcess(), &begun, &ended, &system, &own) == 0) return 0;
  const auto ns = [](const FILETIME& ticks) {  // of 100 ns
    return (static_cast<double>(ticks.dwHighDateTime) * 4294967296.0 + static_cast<double>(ticks.dwLowDateTime)) * 100;
  };
  return ns(system) + ns(own);
}

}  // namespace weftlight::platform
