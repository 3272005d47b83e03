#pragma once
// Walking the numbered rows of a data section.

#include <vector>

#include "wif/names.h"
#include "wif/numbers.h"
#include "wif/parse.h"

namespace weftlight::wif {

/// 0 when the rows run from 0: row 0 says something and no row `count` is there; otherwise 1.
int row_base(const WifSection& section, int count);

/// Calls use(index, key) for each numbered row with a value, index 0-based below `count`. The first of
/// equal keys counts; others, and rows out of range, are reported.
template <class Use>
void each_row(const WifSection& section, int count, int base, Findings& findings, Use use) {
  std::vector<std::string_view> first(static_cast<size_t>(count));
  for (const WifKey& key : section.keys) {
    if (key.value.empty()) continue;
    if (key.number < 0) {
      findings.warn(key.line, section.name + " word", "[" + section.name + "] has a key that is not a number",
                    "ignored; number its lines from 1");
      continue;
    }
    const int index = key.number - base;
    if (index < 0 || index >= count) {
      findings.warn(key.line, section.name + " range",
                    "[" + section.name + "] line " + std::to_string(key.number) + " is beyond the count of " +
                        std::to_string(count),
                    "ignored; raise the count or remove the line");
      continue;
    }
    std::string_view& before = first[static_cast<size_t>(index)];
    if (before.data()) {
      if (before != key.value) {
        findings.warn(
            key.line, section.name + " twice",
            "[" + section.name + "] line " + std::to_string(key.number) + " is there twice, with other values",
            "the first was used; remove one");
      }
      continue;
    }
    before = key.value;
    use(index, key);
  }
}

}  // namespace weftlight::wif
