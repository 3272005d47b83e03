#pragma once
// What the writers of base/files.h say, as a result.

#include <string>
#include <utility>

#include "base/result.h"

namespace weftlight::files {

/// Done, or the problem, which names the file itself.
inline base::Result<void> written(std::string problem) {
  if (problem.empty()) return {};
  return base::failure(base::ErrorKind::kOutput, std::move(problem));
}

}  // namespace weftlight::files
