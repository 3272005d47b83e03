#pragma once
// What a job makes on its way goes with it, however it ends: done, with an error, or thrown out for want of memory.

#include <string>
#include <utility>

#include "platform/file.h"

namespace weftlight::platform {

/// Removes a file, or a folder with all that it holds, at the end of its life. Needs no memory for it.
class RemovedAtEnd {
 public:
  explicit RemovedAtEnd(std::string path) : path_(std::move(path)) {}
  ~RemovedAtEnd() {
    try {
      if (!path_.empty()) remove_with_contents(path_);
    } catch (...) {  // where the system's body needs memory for it, a later start removes it
    }
  }
  RemovedAtEnd(const RemovedAtEnd&) = delete;
  RemovedAtEnd& operator=(const RemovedAtEnd&) = delete;
  /// It stays; whoever takes its path may remove it. Needs no memory for it.
  std::string keep() { return std::exchange(path_, std::string()); }

 private:
  std::string path_;
};

}  // namespace weftlight::platform
