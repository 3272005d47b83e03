#pragma once
// The lines of a WIF file, and an index of its sections and keys that points into the bytes.

#include <cstdint>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "wif/encoding.h"

namespace weftlight::wif {

/// Limits of a file. The largest draft with every table in full has half as many lines.
inline constexpr size_t kMaxLines = 4'000'000, kMaxTextSections = 100'000;

/// Numbers by name, with lookup by string_view.
struct NameHash {
  using is_transparent = void;
  size_t operator()(std::string_view name) const { return std::hash<std::string_view>{}(name); }
};
using NameIndex = std::unordered_map<std::string, uint32_t, NameHash, std::equal_to<>>;

/// One physical line: where its bytes start, how many before the line end, and how many the line end has
/// ("\r\n", "\n", "\r", or none on the last line).
struct WifLine {
  uint32_t begin = 0, size = 0, eol_size = 0;
};

/// A Key=Value line. Key and value are without surrounding blanks.
struct WifKey {
  int line = 0;     // index into WifText::lines
  int number = -1;  // the key as a number; -1: a named key
  std::string_view key, value;
};

/// All the lines under one section name (repeated sections are merged).
struct WifSection {
  struct Block {
    int header = -1;         // index of the [NAME] line; -1: lines before the first header
    int first = 0, end = 0;  // lines of the body, half-open
  };
  std::string name;  // upper case
  std::vector<Block> blocks;
  std::vector<WifKey> keys;
  std::vector<int> other_lines;  // not blank, comment or key
  NameIndex words;               // first key with a value, by name in upper case; numbered rows are not in it
  /// First named key of that name with a value, or nullptr.
  const WifKey* find(std::string_view key) const;
};

struct WifText {
  std::string_view bytes;  // owned by the caller
  bool bom = false;
  Encoding encoding = Encoding::kUtf8;
  std::vector<WifLine> lines;
  std::vector<WifSection> sections;   // by first appearance
  NameIndex section_index;            // of `sections`
  std::vector<int> unclosed_headers;  // lines like "[WARP"
  std::string too_large;              // why there are no sections; in the user's language
  int second_warp_colors = -1;        // header line of a repeated [WARP COLORS] that holds the weft's (Luminescence)

  std::string_view line(int index) const { return bytes.substr(lines[index].begin, lines[index].size); }
  std::string_view eol(int index) const {
    return bytes.substr(lines[index].begin + lines[index].size, lines[index].eol_size);
  }
  const WifSection* find(std::string_view name) const;
  const WifKey* find(std::string_view section, std::string_view key) const;
};

WifText scan_wif(std::string_view bytes);

}  // namespace weftlight::wif
