#pragma once
// Grids have a heavier line every so many threads, on the screen as on paper.

namespace weftlight::draft {

/// Where the weaver says nothing else.
inline constexpr int kHeavyLines = 4;

}  // namespace weftlight::draft
