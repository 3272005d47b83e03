#pragma once
// Environment maps: equirectangular .hdr and .exr pictures.

#include <string>
#include <vector>

#include "files/files.h"
#include "files/names.h"

namespace weftlight::files {

inline constexpr int kEnvironmentWidth = 1024;  // texels across after reading, at most; half as many down

struct ReadEnvironment {
  /// Radiance, 3 channels, finite and >= 0. Row 0 is straight up, the middle column straight ahead.
  std::optional<Image> picture;
  std::string error;                 // "FILE: what is wrong; what to do"; then there is no picture
  std::vector<std::string> remarks;  // values that were corrected, "FILE: what"
};

/// Reads band by band and keeps averages only, so that a large picture takes no more memory than a small one. Texels
/// are weighted by their solid angle.
ReadEnvironment read_environment(const std::string& path);

/// A problem that the header alone shows, as in ReadEnvironment::error; empty: the file may be readable. Takes
/// milliseconds.
std::string environment_problem(const std::string& path);

}  // namespace weftlight::files
