#pragma once
// Converts a design to WIF sections and keys, in the dialect of a file. line_edits.h writes them into lines.

#include <string>
#include <string_view>
#include <vector>

#include "wif/parse.h"

namespace weftlight::wif {

using design::Design;
using draft::BitMatrix;

struct WifEntry {
  int number = -1;  // of a numbered row; -1: a named key
  std::string key;  // the name if number is -1
  std::string value;
  bool is_text = false;  // text, in which ; does not begin a comment
  bool operator==(const WifEntry&) const = default;
};

struct WifEntries {
  std::string name;
  std::vector<WifEntry> entries;  // numbered rows ascend
};

/// The whole design but for [WIF] and [CONTENTS], in the order for one-pass readers. Private sections come last, and
/// only if they hold something that the public ones cannot.
std::vector<WifEntries> sections_of(const Design& design, const WifDialect& dialect);

/// The public sections alone.
std::vector<WifEntries> public_sections_of(const Design& design, const WifDialect& dialect);

/// Appends Weftlight's private sections (write_private.cpp).
void append_private_sections(std::vector<WifEntries>& out, const Design& design, const WifDialect& dialect);

/// Appends the sections of the design's versions (versions.cpp).
void append_versions(std::vector<WifEntries>& out, const Design& design);
/// The sections of versions as the lines of a file have them, odd ones too.
std::vector<WifEntries> version_lines(const WifText& text);
/// Whether that is the name of a section of a version.
bool is_version_section(std::string_view name);
/// Those of a new file, with every number of the yarns.
std::vector<WifEntries> new_file_sections(const Design& design);

/// "1,3,4" of the set bits of a row, counted from `base`; "0" if there are none, empty if `base` is 0.
std::string bit_list(const BitMatrix& bits, int row, int base = 1);

}  // namespace weftlight::wif
