#pragma once
// Shared by the tests of reader and writer: fixtures, and the lines in which two files differ.

#include <string>
#include <string_view>
#include <vector>

#include "wif/wif.h"

namespace weftlight::wif {

std::string fixture(const std::string& name);
std::vector<std::string> fixture_names();

/// Reads a draft that must be usable.
WifFile opened(std::string_view bytes);

struct LineDiff {
  std::vector<std::string> removed, added;  // lines with their line ends, in order
};
/// By the longest common subsequence of lines.
LineDiff line_diff(std::string_view before, std::string_view after);

/// Whether a diagnostic of that line contains the text.
bool says(const WifRead& read, int line, std::string_view words);

}  // namespace weftlight::wif
