#pragma once
// Pictures of the light from all around: .hdr and .exr, equirectangular.

#include <string>
#include <vector>

#include "files/files.h"
#include "files/names.h"

namespace weftlight::files {

inline constexpr int kEnvironmentWidth = 1024;  // texels that a picture is read into at the most; half as high

struct ReadEnvironment {
  /// Radiance, 3 channels, each finite and >= 0; row 0 straight above, the middle column straight ahead.
  std::optional<Image> picture;
  std::string error;                 // "FILE: what is wrong, and what to do"; then there is no picture
  std::vector<std::string> remarks;  // what was set right, "FILE: what"
};

/// Reads band by band and keeps each band's mean alone, so that a large picture takes no more memory than a small one.
/// Of light: texels are weighed by the part of the sphere that they cover.
ReadEnvironment read_environment(const std::string& path);

/// What the file's head alone tells against it, in the words of ReadEnvironment::error, within milliseconds; empty: it
/// may be read.
std::string environment_problem(const std::string& path);

}  // namespace weftlight::files
