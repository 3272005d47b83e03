#pragma once
// Spreads independent jobs over threads. Each job must write what no other job writes, so
// that the bits do not depend on how many threads there are.

#include <algorithm>
#include <atomic>
#include <thread>
#include <vector>

#include "cloth/names.h"

namespace weftlight::cloth {

/// Threads to use for `jobs` jobs; `asked` 0: one a core.
inline int thread_count(int asked, int jobs) {
  const int cores = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  return std::clamp(asked > 0 ? asked : cores, 1, std::max(1, jobs));
}

/// Runs job(0) .. job(jobs - 1), on the calling thread and as many others as asked for.
template <class Job>
void for_each_band(int jobs, int threads, const Job& job) {
  std::atomic<int> next{0};
  const auto work = [&] {
    for (int i = next.fetch_add(1); i < jobs; i = next.fetch_add(1)) job(i);
  };
  std::vector<std::jthread> others;
  for (int t = 1; t < thread_count(threads, jobs); ++t) others.emplace_back(work);
  work();
}

}  // namespace weftlight::cloth
