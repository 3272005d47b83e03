#pragma once
// Environment maps: equirectangular .hdr and .exr pictures.

#include <string>
#include <vector>

#include "files/files.h"

namespace weftlight::files {

inline constexpr int kEnvironmentWidth = 1024;  // texels across after reading, at most; half as many down

struct EnvironmentPicture {
  /// Radiance, 3 channels, finite and >= 0. Row 0 is straight up, the middle column straight ahead.
  Image picture;
  std::vector<std::string> remarks;  // values that were corrected, "FILE: what"
};

/// Reads band by band and keeps averages only, so that a large picture takes no more memory than a small one. Texels
/// are weighted by their solid angle.
base::Result<EnvironmentPicture> read_environment(const std::string& path);

/// The error of read_environment() as far as the header alone shows it; otherwise the file may be readable. Takes
/// milliseconds.
base::Result<void> check_environment(const std::string& path);

}  // namespace weftlight::files
