// The cost of a piece of work in instructions: the same at every run, more for more work.

#include "platform/step_counter.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

namespace weftlight::platform {
namespace {

bool work(std::string_view request) {
  if (request == "fail") return false;
  volatile int sum = 0;
  for (int i = std::atoi(std::string(request).c_str()); i > 0; --i) sum = sum + i;
  return true;
}

TEST(StepCounter, CountsTheSameForTheSameWork) {
  const auto counter = StepCounter::start(work);
  if (!counter) GTEST_SKIP() << "instructions cannot be counted here";
  const auto few = counter->count("10"), again = counter->count("10"), many = counter->count("1010");
  ASSERT_TRUE(few && again && many);
  EXPECT_GT(*few, 30);
  EXPECT_EQ(*few, *again);
  EXPECT_GT(*many - *few, 1000 * 3);
  EXPECT_LT(*many - *few, 1000 * 40);
}

TEST(StepCounter, AFailureEndsTheProcessAndIsTold) {
  const auto counter = StepCounter::start(work);
  if (!counter) GTEST_SKIP() << "instructions cannot be counted here";
  EXPECT_FALSE(counter->count("fail"));
  EXPECT_FALSE(counter->count("10")) << "nobody is there any more";
}

}  // namespace
}  // namespace weftlight::platform
