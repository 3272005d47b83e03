#include "platform/file_lock.h"

#include <utility>

namespace weftlight::platform {

FileLock::FileLock(FileLock&& other) noexcept
    : handle_(std::exchange(other.handle_, -1)),
      answer_(std::exchange(other.answer_, LockAnswer::kNoFile)),
      cause_(other.cause_) {}

FileLock& FileLock::operator=(FileLock&& other) noexcept {
  std::swap(handle_, other.handle_);
  std::swap(answer_, other.answer_);
  std::swap(cause_, other.cause_);
  return *this;
}

}  // namespace weftlight::platform
