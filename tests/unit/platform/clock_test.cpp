// The time of day here and in Greenwich, and processor time.

#include "platform/clock.h"

#include <gtest/gtest.h>

#include <ctime>

#include "../variable.h"

namespace weftlight::platform {
namespace {

TEST(Clock, TimesAreThoseOfTheZone) {
  constexpr int64_t kAt = 1'000'000'000;  // 2001-09-09 01:46:40 UTC
  const std::tm greenwich = utc_time(kAt);
  EXPECT_EQ(greenwich.tm_year, 101);
  EXPECT_EQ(greenwich.tm_mon, 8);
  EXPECT_EQ(greenwich.tm_mday, 9);
  EXPECT_EQ(greenwich.tm_hour, 1);
  EXPECT_EQ(greenwich.tm_min, 46);
  {
    const Variable zone("TZ", "XYZ-5:30");  // east of Greenwich
    ::tzset();
    EXPECT_EQ(local_time(kAt).tm_hour, 7);
    EXPECT_EQ(local_time(kAt).tm_min, 16);
    EXPECT_EQ(local_time(-1).tm_year, 70) << "before 1970 in Greenwich, after it here";
  }
  ::tzset();
}

TEST(Clock, ProcessorTimeGrowsWithWork) {
  const double before = processor_ns();
  volatile double sum = 0;
  // Windows counts it in sixtieths of a second.
  for (int64_t i = 0; i < 2'000'000'000 && processor_ns() <= before; i += 100'000)
    for (int k = 0; k < 100'000; ++k) sum = sum + k;
  EXPECT_GT(processor_ns(), before);
}

}  // namespace
}  // namespace weftlight::platform
