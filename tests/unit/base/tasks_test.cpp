// The newest task of a kind runs, a running one is asked to stop, and results are taken by the thread that asked.

#include "base/tasks.h"

#include <gtest/gtest.h>

#include <atomic>
#include <memory>
#include <new>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "../semaphore.h"
#include "base/caught.h"

namespace weftlight::base {
namespace {

Task task(std::function<void(const RunningTask&)> work, const std::string& kind = {}) {
  Task made;
  made.work = std::move(work);
  made.kind = kind;
  return made;
}

void until_stopped(const RunningTask& running) {
  while (!running.stopped()) std::this_thread::yield();
}

TEST(Tasks, those_in_between_are_skipped) {
  BinarySemaphore started{0}, proceed{0};
  std::vector<int> done;
  TaskRunner runner;
  runner.start(task([&](const RunningTask&) {
    started.release();
    proceed.acquire();
    done.push_back(0);
  }));
  started.acquire();
  for (int i = 1; i <= 3; ++i) runner.start(task([&done, i](const RunningTask&) { done.push_back(i); }));
  EXPECT_TRUE(runner.busy());
  proceed.release();
  runner.wait();
  EXPECT_EQ(done, (std::vector<int>{0, 3}));
  EXPECT_FALSE(runner.busy());
}

TEST(Tasks, a_newer_one_stops_only_its_own_kind) {
  BinarySemaphore started{0}, looked{0};
  std::atomic<bool> stopped{false};
  TaskRunner runner;
  const auto work = [&](const RunningTask& running) {
    started.release();
    looked.acquire();
    stopped = running.stopped();
  };
  runner.start(task(work, "picture"));
  started.acquire();
  runner.start(task([](const RunningTask&) {}, "file"));
  looked.release();
  runner.wait();
  EXPECT_FALSE(stopped);
  runner.start(task(work, "picture"));
  started.acquire();
  runner.start(task([](const RunningTask&) {}, "picture"));
  looked.release();
  runner.wait();
  EXPECT_TRUE(stopped);
}

TEST(Tasks, kinds_keep_their_order) {
  BinarySemaphore started{0}, proceed{0};
  std::string done;
  TaskRunner runner;
  runner.start(task([&](const RunningTask&) { started.release(), proceed.acquire(); }, "first"));
  started.acquire();
  for (const char* kind : {"c", "a", "b", "c"})
    runner.start(task([&done, kind](const RunningTask&) { done += kind; }, kind));
  proceed.release();
  runner.wait();
  EXPECT_EQ(done, "cab");
}

TEST(Tasks, stopped_ones_do_not_begin) {
  BinarySemaphore started{0};
  bool second = false, third = false;
  TaskRunner runner;
  runner.start(task([&](const RunningTask& running) { started.release(), until_stopped(running); }, "first"));
  started.acquire();
  runner.start(task([&](const RunningTask&) { second = true; }, "second"));
  runner.start(task([&](const RunningTask&) { third = true; }, "third"));
  runner.stop("second");
  runner.stop("first");
  runner.wait();
  EXPECT_FALSE(second);
  EXPECT_TRUE(third);
  runner.start(task([&](const RunningTask& running) { started.release(), until_stopped(running); }, "first"));
  started.acquire();
  runner.start(task([&](const RunningTask&) { second = true; }, "second"));
  runner.stop();
  EXPECT_FALSE(runner.busy());
  runner.wait();
  EXPECT_FALSE(second);
}

TEST(Tasks, at_the_end_only_those_that_finish_are_done) {
  for (const bool finishes : {true, false}) {
    BinarySemaphore started{0};
    std::atomic<int> done{0};
    {
      TaskRunner runner;
      Task first = task([&](const RunningTask& running) {
        started.release();
        if (!finishes) until_stopped(running);
        EXPECT_EQ(running.stopped(), !finishes);
        ++done;
      });
      first.finishes = finishes;
      runner.start(first);
      started.acquire();
      for (const char* kind : {"a", "b"}) {
        Task waiting = task([&](const RunningTask&) { ++done; }, kind);
        waiting.finishes = finishes;
        runner.start(waiting);
      }
    }
    EXPECT_EQ(done, finishes ? 3 : 1);
  }
}

TEST(Tasks, what_one_throws_is_told_and_the_next_is_done) {
  std::vector<std::string> told;
  TaskRunner runner;
  const auto thrown = [&](const auto& what) {
    Task throws = task([&](const RunningTask&) { throw what; });
    throws.failed = [&](const Error& error, const RunningTask&) { told.push_back(message(error)); };
    runner.start(throws);
    runner.wait();
    EXPECT_FALSE(runner.busy());
  };
  thrown(std::bad_alloc());
  thrown(std::runtime_error("the line broke"));
  thrown(7);
  EXPECT_EQ(told, (std::vector<std::string>{kNoMemory, "the line broke", "an unknown error"}));
  bool done = false;
  runner.start(task([&](const RunningTask&) { done = true; }));
  runner.wait();
  EXPECT_TRUE(done);
}

TEST(Tasks, who_is_told_may_throw_too) {
  TaskRunner runner;
  Task throws = task([](const RunningTask&) { throw std::bad_alloc(); });
  runner.start(throws);
  throws.failed = [](const auto&, const auto&) { throw std::bad_alloc(); };
  runner.start(throws);
  runner.wait();
  EXPECT_FALSE(runner.busy());
}

TEST(Tasks, one_that_nobody_wants_fails_in_silence) {
  BinarySemaphore started{0};
  bool told = false;
  TaskRunner runner;
  Task throws = task([&](const RunningTask& running) {
    started.release();
    until_stopped(running);
    throw std::bad_alloc();
  });
  throws.failed = [&](const auto&, const auto&) { told = true; };
  runner.start(throws);
  started.acquire();
  runner.stop();
  runner.wait();
  EXPECT_FALSE(told);
}

TEST(Tasks, results_are_taken_in_order_by_the_thread_that_takes) {
  std::vector<std::string> taken;
  std::thread::id on;
  TaskRunner runner;
  runner.start(task_with_result([](const RunningTask&) { return std::string("one"); },
                                [&](const Result<std::string>& result) {
                                  on = std::this_thread::get_id();
                                  taken.push_back(*result);
                                }));
  runner.wait();
  runner.start(task_with_result([](const RunningTask&) -> std::string { throw std::runtime_error("two"); },
                                [&](const Result<std::string>& result) { taken.push_back(problem_of(result)); }));
  runner.wait();
  runner.start(task_with_result([](const RunningTask&) -> Result<void> { return failure(ErrorKind::kInput, "three"); },
                                [&](const Result<void>& result) { taken.push_back(problem_of(result)); }));
  runner.wait();
  EXPECT_TRUE(taken.empty()) << "nothing is taken before it is asked for";
  EXPECT_TRUE(runner.take());
  EXPECT_EQ(taken, (std::vector<std::string>{"one", "two", "three"}));
  EXPECT_EQ(on, std::this_thread::get_id());
  EXPECT_FALSE(runner.take());
}

TEST(Tasks, results_of_a_stopped_one_are_not_taken) {
  int taken = 0;
  TaskRunner runner;
  const auto delivers = [&](const std::string& kind, bool finishes) {
    Task made = task([&](const RunningTask& running) { running.deliver([&] { ++taken; }); }, kind);
    made.finishes = finishes;
    runner.start(made);
    runner.wait();
  };
  delivers("a", false);
  runner.start(task([](const RunningTask&) {}, "a"));
  runner.wait();
  runner.take();
  EXPECT_EQ(taken, 1) << "it had ended before the newer one";
  BinarySemaphore delivered{0};
  runner.start(task(
      [&](const RunningTask& running) {
        running.deliver([&] { ++taken; });
        delivered.release();
        until_stopped(running);
        running.deliver([&] { ++taken; });
      },
      "a"));
  delivered.acquire();
  runner.stop("a");
  runner.wait();
  runner.take();
  EXPECT_EQ(taken, 1);
  delivers("save", true);
  runner.stop();
  runner.take();
  EXPECT_EQ(taken, 2) << "one that finishes is not stopped";
}

/// Work that hangs until it is let go. What it uses is its own, as that of each task that may be left.
struct Hanging {
  BinarySemaphore started{0}, let_go{0}, ended{0};
  std::atomic<bool> taken{false};
  std::atomic<int> woken{0};
};

Task hanging_task(const std::shared_ptr<Hanging>& it) {
  Task made = task_with_result(
      [it](const RunningTask& running) {
        it->started.release();
        it->let_go.acquire();
        running.report(0.5f, "it goes on");
        return std::shared_ptr<Hanging>(it.get(), [it](Hanging* hanging) { hanging->ended.release(); });
      },
      [it](const Result<std::shared_ptr<Hanging>>&) { it->taken = true; });
  made.kind = "hangs";
  made.may_be_left = true;
  return made;
}

TEST(Tasks, one_that_hangs_is_left_and_the_others_are_done) {
  const auto it = std::make_shared<Hanging>();
  TaskRunner runner([it] { ++it->woken; });
  runner.start(hanging_task(it));
  it->started.acquire();
  bool done = false;
  runner.start(task([&done](const RunningTask&) { done = true; }, "another"));
  runner.stop("hangs");
  runner.wait();
  EXPECT_TRUE(done);
  EXPECT_FALSE(runner.busy());
  it->let_go.release();
  it->ended.acquire();
  runner.take();
  EXPECT_FALSE(it->taken);
  EXPECT_EQ(it->woken, 0);
}

TEST(Tasks, at_the_end_one_that_hangs_is_left_and_those_that_finish_are_done) {
  const auto it = std::make_shared<Hanging>();
  bool done = false;
  {
    TaskRunner runner([it] { ++it->woken; });
    runner.start(hanging_task(it));
    it->started.acquire();
    Task save = task([&done](const RunningTask&) { done = true; }, "save");
    save.finishes = true;
    runner.start(std::move(save));
  }
  EXPECT_TRUE(done);
  it->let_go.release();
  it->ended.acquire();
  EXPECT_FALSE(it->taken);
  EXPECT_EQ(it->woken, 0);
}

TEST(Tasks, progress_is_shown_and_wakes_without_a_lock) {
  BinarySemaphore told{0}, proceed{0};
  std::atomic<int> wakes{0};
  TaskRunner* asked = nullptr;
  TaskRunner runner([&] {
    ++wakes;
    EXPECT_TRUE(asked->busy()) << "would wait for ever under the runner's lock";
  });
  asked = &runner;
  Task slow = task(
      [&](const RunningTask& running) {
        running.report(0.25f, "Counting");
        running.report(0.251f);  // not worth waking for
        told.release();
        proceed.acquire();
        running.deliver([] {});
      },
      "count");
  slow.name = "Counting the ends";
  runner.start(slow);
  told.acquire();
  Task waiting = task([](const RunningTask&) {}, "file");
  waiting.name = "Saving twill.wif", waiting.finishes = true;
  runner.start(waiting);
  runner.start(task([](const RunningTask&) {}, "nameless"));
  const std::vector<ShownTask> shown = runner.shown();
  ASSERT_EQ(shown.size(), 2u);
  EXPECT_EQ(shown[0].name, "Counting the ends");
  EXPECT_EQ(shown[0].sentence, "Counting");
  EXPECT_FLOAT_EQ(shown[0].share, 0.25f);
  EXPECT_TRUE(shown[0].can_stop);
  EXPECT_EQ(shown[1].name, "Saving twill.wif");
  EXPECT_FALSE(shown[1].can_stop);
  EXPECT_TRUE(runner.busy("file"));
  EXPECT_FALSE(runner.busy("picture"));
  EXPECT_FALSE(runner.wait_for(std::chrono::milliseconds(0)));
  EXPECT_EQ(wakes, 1);
  proceed.release();
  runner.wait();
  EXPECT_EQ(wakes, 2);
}

}  // namespace
}  // namespace weftlight::base
