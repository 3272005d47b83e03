// Loops run every job once for any number of threads, also nested and when a job throws.

#include "base/loops.h"

#include <gtest/gtest.h>

#include <atomic>
#include <fstream>
#include <new>
#include <stdexcept>
#include <vector>

namespace weftlight::base {
namespace {

TEST(Loops, every_job_runs_once) {
  for (const int threads : {0, 1, 2, 3, 16}) {
    std::vector<int> done(1000, 0);
    for_each_job(1000, threads, [&](int i) { ++done[static_cast<size_t>(i)]; });
    EXPECT_EQ(done, std::vector<int>(1000, 1)) << threads;
  }
}

TEST(Loops, zero_jobs_do_nothing) {
  for_each_job(0, [](int) { FAIL(); });
  for_each_job(-3, [](int) { FAIL(); });
}

TEST(Loops, loops_may_be_nested) {
  std::atomic<int> sum{0};
  for_each_job(20, 2, [&](int i) { for_each_job(20, [&](int k) { sum += i * 20 + k; }); });
  EXPECT_EQ(sum, 400 * 399 / 2);
}

/// Bytes of this process in memory.
long resident_bytes() {
  std::ifstream file("/proc/self/statm");
  long pages = 0, resident = 0;
  file >> pages >> resident;
  return resident * 4096;
}

TEST(Loops, a_thousand_loops_take_no_memory) {
  const auto loops = [](int count) {
    for (int i = 0; i < count; ++i) for_each_job(20, 2, [](int) {});
  };
  if (core_count() < 2) GTEST_SKIP() << "one core: loops need no threads";
  loops(200);
  const long before = resident_bytes();
  if (before == 0) GTEST_SKIP() << "the system does not tell what is in memory";
  loops(2000);
  EXPECT_LT(resident_bytes() - before, 4 << 20);
}

TEST(Loops, exceptions_of_a_job_are_rethrown) {
  EXPECT_THROW(for_each_job(100,
                            [](int i) {
                              if (i == 50) throw std::runtime_error("fifty");
                            }),
               std::runtime_error);
}

TEST(Loops, memory_that_a_job_lacks_is_the_callers_to_tell) {
  for (const int threads : {0, 1, 2}) {
    EXPECT_THROW(for_each_job(100, threads,
                              [](int i) {
                                for_each_job(10, [i](int k) {
                                  if (i == 50 && k == 5) throw std::bad_alloc();
                                });
                              }),
                 std::bad_alloc);
    std::atomic<int> done{0};
    for_each_job(100, threads, [&](int) { ++done; });
    EXPECT_EQ(done, 100) << "the next loop is whole";
  }
}

TEST(Loops, core_count_is_positive) { EXPECT_GE(core_count(), 1); }

}  // namespace
}  // namespace weftlight::base
