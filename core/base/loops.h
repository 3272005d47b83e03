#pragma once
// Loops over independent jobs on all cores, through oneTBB. Each job writes what no other job writes, so that
// the bits do not depend on how many threads there are.

#include <functional>

namespace weftlight::base {

/// Cores that this process may use, at least one.
int core_count();

/// Runs job(0) .. job(count - 1), the calling thread among those that work; returns when all are done. `threads`
/// at the most, and no more than cores; 0: one a core. What a job throws is thrown on. Jobs may hold loops of their
/// own.
void for_each_job(int count, int threads, const std::function<void(int)>& job);
inline void for_each_job(int count, const std::function<void(int)>& job) { for_each_job(count, 0, job); }

}  // namespace weftlight::base
