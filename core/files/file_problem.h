#pragma once
// Error messages that name the file.

#include <string>

#include "base/text.h"

namespace weftlight::files {

/// "cloth.png: the disk is full".
inline std::string file_problem(const std::string& path, const std::string& problem) {
  return base::fill(base::tr("{file}: {problem}"), base::arg("file", path), base::arg("problem", problem));
}

}  // namespace weftlight::files
