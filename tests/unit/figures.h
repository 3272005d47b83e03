#pragma once
// What a gate measured: the method that fails there beside ours, printed and kept with the test's result.
// docs/gates.md is written from these lines.

#include <gtest/gtest.h>

#include <cstdio>
#include <string>

namespace weftlight {

/// A number without its last zeros.
inline std::string text(float v) {
  char out[32];
  std::snprintf(out, sizeof out, "%g", static_cast<double>(v));
  return out;
}

inline void figure(const std::string& what, double failing, double ours) {
  char both[64];
  std::snprintf(both, sizeof both, "fails %.3g, ours %.3g", failing, ours);
  std::printf("  %s: %s\n", what.c_str(), both);
  testing::Test::RecordProperty(what, both);
}

}  // namespace weftlight
