#pragma once
// What a job throws, as words for people: where threads run jobs, nothing may be thrown on.

#include <string>

namespace weftlight::base {

inline constexpr const char* kNoMemory = "there is not enough memory";

/// In a handler: what was thrown. Never empty.
std::string words_of_thrown() noexcept;

/// Runs `job`; what it threw, in words; empty: nothing.
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
