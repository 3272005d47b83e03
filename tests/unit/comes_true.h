#pragma once
// Waits for what other threads do.

#include <chrono>
#include <thread>

namespace weftlight {

/// Whether `holds()` becomes true. It is given a minute: a busy machine is slow, and a test that waits in vain fails.
template <class Holds>
bool comes_true(const Holds& holds) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::minutes(1);
  while (!holds()) {
    if (std::chrono::steady_clock::now() > end) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  return true;
}

}  // namespace weftlight
