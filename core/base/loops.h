#pragma once
// Loops over independent jobs on all cores, through oneTBB. No two jobs write the same data, so the result does not
// depend on the number of threads.

#include <functional>

namespace weftlight::base {

/// Cores that this process may use, at least one.
int core_count();

/// Runs job(0) .. job(count - 1), also on the calling thread, and returns when all are done. `threads`: the most
/// threads; 0: one per core. Exceptions of jobs are rethrown. Jobs may contain loops.
void for_each_job(int count, int threads, const std::function<void(int)>& job);
inline void for_each_job(int count, const std::function<void(int)>& job) { for_each_job(count, 0, job); }

}  // namespace weftlight::base
