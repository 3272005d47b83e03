// The newest job of a kind runs, jobs in between are skipped, and a running job is asked to stop.

#include "base/worker.h"

#include <gtest/gtest.h>

#include <atomic>
#include <new>
#include <semaphore>
#include <stdexcept>
#include <string>
#include <vector>

#include "base/caught.h"

namespace weftlight::base {
namespace {

TEST(Worker, jobs_in_between_are_skipped) {
  std::binary_semaphore started{0}, proceed{0};
  std::vector<int> done;
  Worker worker;
  worker.post([&](const std::stop_token&) {
    started.release();
    proceed.acquire();
    done.push_back(0);
  });
  started.acquire();
  for (int i = 1; i <= 3; ++i) worker.post([&done, i](const std::stop_token&) { done.push_back(i); });
  EXPECT_TRUE(worker.busy());
  proceed.release();
  worker.wait();
  EXPECT_EQ(done, (std::vector<int>{0, 3}));
  EXPECT_FALSE(worker.busy());
}

TEST(Worker, a_newer_job_stops_only_its_own_kind) {
  std::binary_semaphore started{0}, looked{0};
  std::atomic<bool> stopped{false};
  Worker worker;
  const auto job = [&](const std::stop_token& stop) {
    started.release();
    looked.acquire();
    stopped = stop.stop_requested();
  };
  worker.post(job, "picture");
  started.acquire();
  worker.post([](const std::stop_token&) {}, "file");
  looked.release();
  worker.wait();
  EXPECT_FALSE(stopped);
  worker.post(job, "picture");
  started.acquire();
  worker.post([](const std::stop_token&) {}, "picture");
  looked.release();
  worker.wait();
  EXPECT_TRUE(stopped);
}

TEST(Worker, kinds_keep_their_order) {
  std::binary_semaphore started{0}, proceed{0};
  std::string done;
  Worker worker;
  worker.post([&](const std::stop_token&) { started.release(), proceed.acquire(); }, "first");
  started.acquire();
  for (const char* kind : {"c", "a", "b", "c"})
    worker.post([&done, kind](const std::stop_token&) { done += kind; }, kind);
  proceed.release();
  worker.wait();
  EXPECT_EQ(done, "cab");
}

TEST(Worker, dropped_jobs_do_not_run) {
  std::binary_semaphore started{0};
  bool second = false;
  Worker worker;
  worker.post([&](const std::stop_token& stop) {
    started.release();
    while (!stop.stop_requested()) std::this_thread::yield();
  });
  started.acquire();
  worker.post([&](const std::stop_token&) { second = true; }, "other");
  worker.drop();
  EXPECT_FALSE(worker.busy());
  worker.wait();
  EXPECT_FALSE(second);
}

TEST(Worker, the_destructor_drops_or_finishes_waiting_jobs) {
  for (const auto leaving : {Worker::Leaving::kFinish, Worker::Leaving::kDrop}) {
    std::binary_semaphore started{0};
    std::atomic<int> done{0};
    {
      Worker worker(leaving);
      worker.post([&](const std::stop_token& stop) {
        started.release();
        while (leaving == Worker::Leaving::kDrop && !stop.stop_requested()) std::this_thread::yield();
        ++done;
      });
      started.acquire();
      for (const char* kind : {"a", "b"}) worker.post([&](const std::stop_token&) { ++done; }, kind);
    }
    EXPECT_EQ(done, leaving == Worker::Leaving::kFinish ? 3 : 1);
  }
}

TEST(Worker, what_a_job_throws_is_told_and_the_next_is_done) {
  std::vector<std::string> told;
  Worker worker([&](const std::string& why, const auto&) { told.push_back(why); });
  const auto thrown = [&](const auto& what) {
    worker.post([&](const std::stop_token&) { throw what; });
    worker.wait();
    EXPECT_FALSE(worker.busy());
  };
  thrown(std::bad_alloc());
  thrown(std::runtime_error("the line broke"));
  thrown(7);
  EXPECT_EQ(told, (std::vector<std::string>{kNoMemory, "the line broke", "an unknown error"}));
  bool done = false;
  worker.post([&](const std::stop_token&) { done = true; });
  worker.wait();
  EXPECT_TRUE(done);
}

TEST(Worker, who_is_told_may_throw_too) {
  Worker worker([](const auto&, const auto&) { throw std::bad_alloc(); });
  worker.post([](const std::stop_token&) { throw std::bad_alloc(); });
  worker.wait();
  Worker deaf;
  deaf.post([](const std::stop_token&) { throw std::bad_alloc(); });
  deaf.wait();
  EXPECT_FALSE(worker.busy() || deaf.busy());
}

TEST(Worker, a_job_that_nobody_wants_fails_in_silence) {
  std::binary_semaphore started{0};
  bool told = false;
  Worker worker([&](const auto&, const auto&) { told = true; });
  worker.post([&](const std::stop_token& stop) {
    started.release();
    while (!stop.stop_requested()) std::this_thread::yield();
    throw std::bad_alloc();
  });
  started.acquire();
  worker.drop();
  worker.wait();
  EXPECT_FALSE(told);
}

}  // namespace
}  // namespace weftlight::base
