#include "base/loops.h"

#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>

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
  tbb::task_arena arena(workers);
  SanitizerFence begin, end;
  begin.release();
  arena.execute([&] {
    tbb::parallel_for(0, count, [&](int i) {
      begin.acquire();
      job(i);
      end.release();
    });
  });
  end.acquire();
}

}  // namespace weftlight::base
