#pragma once

namespace weftlight::cloth {

/// Index i of a periodic row of n, 0..n - 1.
inline int wrap(int i, int n) {
  if (i >= 0 && i < n) return i;  // nearly always, and a division takes long
  const int r = i % n;
  return r < 0 ? r + n : r;
}

}  // namespace weftlight::cloth
