#pragma once
// How an export says how far it is, and how it is stopped.

#include <functional>
#include <stop_token>

#include "base/result.h"

namespace weftlight::texture_set {

/// Progress report and cancellation.
struct ExportProgress {
  std::function<void(float fraction)> report{};  // 0..1, on the calling thread; may be empty
  std::stop_token stop{};
};
/// The error of a set that was stopped, of kCancelled. The earlier set is unchanged.
base::Failure stopped();

}  // namespace weftlight::texture_set
