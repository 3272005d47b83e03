#pragma once
// In place of std::binary_semaphore, which does not wake its waiters in GCC 12 for Windows.

#include <condition_variable>
#include <mutex>

namespace weftlight {

class BinarySemaphore {
 public:
  explicit BinarySemaphore(int free) : free_(free != 0) {}
  void release() {
    {
      const std::lock_guard lock(mutex_);
      free_ = true;
    }
    freed_.notify_all();
  }
  void acquire() {
    std::unique_lock lock(mutex_);
    freed_.wait(lock, [this] { return free_; });
    free_ = false;
  }

 private:
  std::mutex mutex_;
  std::condition_variable freed_;
  bool free_;
};

}  // namespace weftlight
