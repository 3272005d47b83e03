// The body of loops without oneTBB: a few threads that wait for loops, and take part in the newest first. A loop within
// a loop runs on the thread that begins it and on those that are idle.

#include "base/loops.h"

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <exception>
#include <list>
#include <memory>
#include <mutex>
#include <thread>

namespace weftlight::base {
namespace {

struct Loop {
  Loop(int jobs, const std::function<void(int)>& body, int most) : count(jobs), job(body), room(most) {}

  /// Runs jobs until none is left.
  void work() {
    for (int i = next++; i < count; i = next++) {
      try {
        job(i);
      } catch (...) {
        const std::lock_guard lock(mutex);
        if (!thrown) thrown = std::current_exception();
        next = count;
      }
    }
  }

  const int count;
  const std::function<void(int)>& job;
  int room;         // for more threads; guarded by the pool's mutex, as is:
  int working = 0;  // threads of the pool
  std::atomic<int> next{0};
  std::mutex mutex;
  std::exception_ptr thrown;
};

class Pool {
 public:
  explicit Pool(int threads) {
    for (int i = 0; i < threads; ++i) std::thread([this] { serve(); }).detach();
  }

  void run(Loop& loop) {
    {
      const std::lock_guard lock(mutex_);
      loops_.push_front(&loop);
    }
    begun_.notify_all();
    loop.work();
    std::unique_lock lock(mutex_);
    loops_.remove(&loop);
    ended_.wait(lock, [&loop] { return loop.working == 0; });
  }

 private:
  [[noreturn]] void serve() {
    std::unique_lock lock(mutex_);
    for (;;) {
      const auto open = [](const Loop* one) { return one->room > 0 && one->next < one->count; };
      const auto at = std::find_if(loops_.begin(), loops_.end(), open);
      if (at == loops_.end()) {
        begun_.wait(lock);
        continue;
      }
      Loop& loop = **at;
      --loop.room, ++loop.working;
      lock.unlock();
      loop.work();
      lock.lock();
      --loop.working;
      ended_.notify_all();
    }
  }

  std::mutex mutex_;
  std::condition_variable begun_, ended_;
  std::list<Loop*> loops_;
};

/// Lives until the end of the process, in which loops may still run.
Pool& pool() {
  static Pool& threads = *new Pool(core_count() - 1);
  return threads;
}

}  // namespace

int core_count() {
  static constexpr int kMost = 8;  // each takes memory of the page
  return std::clamp(static_cast<int>(std::thread::hardware_concurrency()), 1, kMost);
}

void for_each_job(int count, int threads, const std::function<void(int)>& job) {
  const int workers = std::min({threads > 0 ? threads : core_count(), core_count(), count});
  if (workers <= 1) {
    for (int i = 0; i < count; ++i) job(i);
    return;
  }
  Loop loop(count, job, workers - 1);
  pool().run(loop);
  if (loop.thrown) std::rethrow_exception(loop.thrown);
}

}  // namespace weftlight::base
