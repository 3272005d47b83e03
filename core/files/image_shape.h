#pragma once
// What an image must be to be written.

#include "files/files.h"

namespace weftlight::files {

constexpr int kMaxSide = 65536;

/// Whether the texels are those of its size, which is at most kMaxSide by kMaxSide, with at most so many channels and
/// values in all.
base::Result<void> check_shape(const Image& image, int max_channels, int64_t max_values, const std::string& path);

}  // namespace weftlight::files
