#pragma once
// Counts the instructions that the processor executes for a piece of work: a cost that other load on the machine does
// not change.

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string_view>

namespace weftlight::platform {

/// Another process of this program that works and is counted, on one thread.
class StepCounter {
 public:
  /// Does what `request` says, in the other process; false on failure. Bytes of any kind.
  using Work = std::function<bool(std::string_view request)>;
  /// Call it while this process is small and has no other threads. Null where instructions cannot be counted.
  static std::unique_ptr<StepCounter> start(const Work& work);
  ~StepCounter();
  StepCounter(const StepCounter&) = delete;
  StepCounter& operator=(const StepCounter&) = delete;

  /// Instructions of the third of three runs, so that programs are compiled and pages mapped. None after a failure, or
  /// if it takes more than ten minutes; the process has then ended.
  std::optional<int64_t> count(std::string_view request);

 private:
  StepCounter() = default;
  std::int64_t process_ = 0;
  std::intptr_t line_ = -1;  // to the process
};

}  // namespace weftlight::platform
