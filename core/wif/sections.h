#pragma once
// A design as WIF sections and keys, in the terms of a file: the half of writing that knows the format.
// The half that knows the lines is patch.h.

#include <string>
#include <vector>

#include "wif/names.h"
#include "wif/parse.h"

namespace weftlight::wif {

struct WifEntry {
  int number = -1;  // of a numbered row; -1: a named key
  std::string key;  // the name when number is -1
  std::string value;
  bool is_text = false;  // words, where a ; would be no comment
  bool operator==(const WifEntry&) const = default;
};

struct WifEntries {
  std::string name;
  std::vector<WifEntry> entries;  // numbered rows ascend
};

/// All that a design says, but for [WIF] and [CONTENTS]; in the order one-pass readers want. Weftlight's
/// private sections come last, each only when it says something that WIF's own do not.
std::vector<WifEntries> sections_of(const Design& design, const WifDialect& dialect);

/// The public sections alone.
std::vector<WifEntries> public_sections_of(const Design& design, const WifDialect& dialect);

/// Appends Weftlight's private sections (private_sections.cpp).
void append_private_sections(std::vector<WifEntries>& out, const Design& design, const WifDialect& dialect);

/// "1,3,4" of the set bits of a row, counted from `base`; "0" for none, empty where 0 is a number.
std::string bit_list(const BitMatrix& bits, int row, int base = 1);

}  // namespace weftlight::wif
