#pragma once
// Exceptions of a job as errors. A thread that runs jobs lets no exception out.

#include <type_traits>

#include "base/result.h"

namespace weftlight::base {

/// Runs `job`. Returns its Result<void>, if it has one, or the error of what it threw (thrown()).
template <class Job>
Result<void> caught(const Job& job, ErrorKind kind = ErrorKind::kInput) noexcept {
  try {
    if constexpr (std::is_void_v<std::invoke_result_t<const Job&>>) {
      job();
      return {};
    } else {
      return job();
    }
  } catch (...) {
    return thrown(kind);
  }
}

}  // namespace weftlight::base
