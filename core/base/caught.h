#pragma once
// Exceptions of a job as text for users. A thread that runs jobs lets no exception out.

#include <string>

#include "base/text.h"

namespace weftlight::base {

inline constexpr const char* kNoMemory = mark("there is not enough memory");

/// Inside a catch block: the text of the exception. Never empty.
std::string words_of_thrown() noexcept;

/// Runs `job`. Returns the text of what it threw, or an empty string.
template <class Job>
std::string caught(const Job& job) noexcept {
  try {
    job();
    return {};
  } catch (...) {
    return words_of_thrown();
  }
}

}  // namespace weftlight::base
