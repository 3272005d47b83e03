#pragma once
// How far two pictures are apart.

#include <cmath>

#include "files/files.h"

namespace weftlight {

/// Root mean square difference of two RGBA pictures' colours over the root mean square of the first.
inline double relative_rms(const files::Image& a, const files::Image& b) {
  double off = 0, all = 1e-30;
  for (size_t i = 0; i < a.texels.size(); ++i) {
    if (i % 4 == 3) continue;
    const double d = static_cast<double>(a.texels[i] - b.texels[i]);
    off += d * d, all += static_cast<double>(a.texels[i]) * static_cast<double>(a.texels[i]);
  }
  return std::sqrt(off / all);
}

}  // namespace weftlight
