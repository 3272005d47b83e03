#include "lines.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "paths.h"

namespace weftlight::wif {

using base::read_file;

namespace {

std::vector<std::string> split(std::string_view bytes) {
  std::vector<std::string> lines;
  size_t begin = 0;
  for (size_t i = 0; i < bytes.size(); ++i) {
    if (bytes[i] != '\n' && (bytes[i] != '\r' || (i + 1 < bytes.size() && bytes[i + 1] == '\n'))) continue;
    lines.emplace_back(bytes.substr(begin, i + 1 - begin));
    begin = i + 1;
  }
  if (begin < bytes.size()) lines.emplace_back(bytes.substr(begin));
  return lines;
}

const std::string kFixtures = std::string(WEFTLIGHT_TESTS_DIR) + "/fixtures/";

}  // namespace

std::string fixture(const std::string& name) {
  const auto bytes = read_file(kFixtures + name);
  EXPECT_TRUE(bytes) << problem_of(bytes);
  return bytes.value_or("");
}

std::vector<std::string> fixture_names() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(kFixtures)) {
    if (entry.path().extension() == ".wif") names.push_back(entry.path().filename().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

WifFile opened(std::string_view bytes) {
  WifRead read = read_wif(bytes);
  EXPECT_TRUE(read.file) << (read.diagnostics.empty() ? "" : read.diagnostics.back().text);
  return read.file ? std::move(*read.file) : WifFile{};
}

LineDiff line_diff(std::string_view before, std::string_view after) {
  const std::vector<std::string> a = split(before), b = split(after);
  std::vector<std::vector<int>> common(a.size() + 1, std::vector<int>(b.size() + 1, 0));
  for (size_t i = a.size(); i-- > 0;) {
    for (size_t j = b.size(); j-- > 0;) {
      common[i][j] = a[i] == b[j] ? common[i + 1][j + 1] + 1 : std::max(common[i + 1][j], common[i][j + 1]);
    }
  }
  LineDiff diff;
  size_t i = 0, j = 0;
  while (i < a.size() || j < b.size()) {
    if (i < a.size() && j < b.size() && a[i] == b[j]) {
      ++i;
      ++j;
    } else if (j == b.size() || (i < a.size() && common[i + 1][j] >= common[i][j + 1])) {
      diff.removed.push_back(a[i++]);
    } else {
      diff.added.push_back(b[j++]);
    }
  }
  return diff;
}

bool says(const WifRead& read, int line, std::string_view words) {
  return std::any_of(read.diagnostics.begin(), read.diagnostics.end(), [&](const Diagnostic& d) {
    return d.line == line && d.text.find(words) != std::string::npos && !d.remedy.empty();
  });
}

}  // namespace weftlight::wif
