#pragma once
// Runs a function on every row, on all processors. Rows are independent, so the result is the same
// however many there are.

#include <algorithm>
#include <atomic>
#include <thread>
#include <vector>

#include "texture_set/names.h"

namespace weftlight::texture_set {

template <class Function>
void for_rows(int rows, const Function& do_row) {
  const int workers = std::clamp(static_cast<int>(std::thread::hardware_concurrency()), 1, std::max(1, rows / 16));
  std::atomic<int> next{0};
  auto work = [&] {
    for (int y = next++; y < rows; y = next++) do_row(y);
  };
  std::vector<std::jthread> threads;
  for (int i = 1; i < workers; ++i) threads.emplace_back(work);
  work();
}

}  // namespace weftlight::texture_set
