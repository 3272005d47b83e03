#include "platform/clock.h"

#include <windows.h>

#include <ctime>

namespace weftlight::platform {

namespace {

/// The parts of a time by a function of the C library, which refuses those before 1970: the calendar of 28 years later
/// is the same, back to 1900.
std::tm parts_of(int64_t seconds, errno_t (*split)(std::tm*, const std::time_t*)) {
  constexpr int kYears = 28;
  constexpr int64_t kSeconds = (int64_t{kYears} * 365 + kYears / 4) * 86400;
  int earlier = 0;
  for (; seconds < 0 && earlier < 3; ++earlier) seconds += kSeconds;
  const std::time_t at = seconds;
  std::tm parts{};
  split(&parts, &at);
  parts.tm_year -= earlier * kYears;
  return parts;
}

}  // namespace

std::tm local_time(int64_t seconds) {
  return parts_of(seconds, [](std::tm* parts, const std::time_t* at) { return ::localtime_s(parts, at); });
}

std::tm utc_time(int64_t seconds) {
  return parts_of(seconds, [](std::tm* parts, const std::time_t* at) { return ::gmtime_s(parts, at); });
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
