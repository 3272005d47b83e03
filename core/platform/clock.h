#pragma once
// The time of day in the user's time zone, and processor time.

#include <cstdint>
#include <ctime>

namespace weftlight::platform {

/// The parts of a time in seconds since 1970: in the user's time zone, and in that of Greenwich (UTC).
std::tm local_time(int64_t seconds);
std::tm utc_time(int64_t seconds);

/// Nanoseconds that all threads of this program have computed since it started.
double processor_ns();

}  // namespace weftlight::platform
