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

/// What one thread did before it gives, another sees after it takes. oneTBB holds to that, but its library is not built
/// for the thread sanitizer, which has to be told.
struct HandOver {
#if defined(__SANITIZE_THREAD__)
  void give() { __tsan_release(this); }
  void take() { __tsan_acquire(this); }
#else
  void give() {}
  void take() {}
#endif
};

}  // namespace

int core_count() { return std::max(1, tbb::info::default_concurrency()); }

void for_each_job(int count, int threads, const std::function<void(int)>& job) {
  const int most = std::min({threads > 0 ? threads : core_count(), core_count(), count});
  if (most <= 1) {
    for (int i = 0; i < count; ++i) job(i);
    return;
  }
  // An arena of its own: a loop within a job is not held to the threads of the loop around it, and a thread that
  // waits for its own loop takes up no job of another, whose locks it may hold.
  tbb::task_arena arena(most);
  HandOver begun, done;
  begun.give();
  arena.execute([&] {
    tbb::parallel_for(0, count, [&](int i) {
      begun.take();
      job(i);
      done.give();
    });
  });
  done.take();
}

}  // namespace weftlight::base
