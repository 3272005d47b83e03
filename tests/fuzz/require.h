#pragma once
// Assertion of a fuzz target: if it fails, the run ends and the input is kept.

#include <cstdio>
#include <cstdlib>

inline void require(bool holds, const char* what) {
  if (holds) return;
  std::fprintf(stderr, "does not hold: %s\n", what);
  std::abort();
}
