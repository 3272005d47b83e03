#include "base/loops.h"

#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

#if defined(__SANITIZE_THREAD__)
#include <sanitizer/tsan_interface.h>
#endif

namespace weftlight::base {
namespace {

/// Tells the thread sanitizer that writes before release() are visible after acquire(). oneTBB guarantees it, but its
/// library is not instrumented.
struct SanitizerFence {
#if defined(__SANITIZE_THREAD__)
  void release() { __tsan_release(this); }
  void acquire() { __tsan_acquire(this); }
#else
  void release() {}
  void acquire() {}
#endif
};

/// Arenas that no loop uses at present, to be used again: oneTBB (2021.8) loses 7 KB with each arena that ends.
class IdleArenas {
 public:
  std::unique_ptr<tbb::task_arena> take(int workers) {
    const std::lock_guard lock(mutex_);
    const auto fits = [workers](const auto& arena) { return arena->max_concurrency() == workers; };
    const auto found = std::find_if(idle_.begin(), idle_.end(), fits);
    if (found == idle_.end()) {
      idle_.reserve(++made_);  // giving back takes no memory
      return std::make_unique<tbb::task_arena>(workers);
    }
    std::unique_ptr<tbb::task_arena> arena = std::move(*found);
    idle_.erase(found);
    return arena;
  }
  void give_back(std::unique_ptr<tbb::task_arena> arena) noexcept {
    const std::lock_guard lock(mutex_);
    idle_.push_back(std::move(arena));
  }

 private:
  std::mutex mutex_;
  std::vector<std::unique_ptr<tbb::task_arena>> idle_;
  size_t made_ = 0;
};

/// Lives until the end of the process, in which loops may still run.
IdleArenas& idle_arenas() {
  static IdleArenas& arenas = *new IdleArenas;
  return arenas;
}

/// An arena for one loop.
class LoopArena {
 public:
  explicit LoopArena(int workers) : arena_(idle_arenas().take(workers)) {}
  ~LoopArena() { idle_arenas().give_back(std::move(arena_)); }
  LoopArena(const LoopArena&) = delete;
  LoopArena& operator=(const LoopArena&) = delete;
  tbb::task_arena& operator*() const { return *arena_; }

 private:
  std::unique_ptr<tbb::task_arena> arena_;
};

}  // namespace

int core_count() { return std::max(1, tbb::info::default_concurrency()); }

void for_each_job(int count, int threads, const std::function<void(int)>& job) {
  const int workers = std::min({threads > 0 ? threads : core_count(), core_count(), count});
  if (workers <= 1) {
    for (int i = 0; i < count; ++i) job(i);
    return;
  }
  // A separate arena: an inner loop is not limited to the threads of the outer loop, and a thread that waits for its
  // loop does not run a job of another loop, whose locks it might need.
  const LoopArena arena(workers);
  SanitizerFence begin, end;
  begin.release();
  (*arena).execute([&] {
    tbb::parallel_for(0, count, [&](int i) {
      begin.acquire();
      job(i);
      end.release();
    });
  });
  end.acquire();
}

}  // namespace weftlight::base
