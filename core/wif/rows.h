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
void each_row(const WifSection& section, int count, int base, Diagnostics& diagnostics, Use use) {
  std::vector<const WifKey*> first(static_cast<size_t>(count), nullptr);
  for (const WifKey& key : section.keys) {
    if (key.value.empty()) continue;
    if (key.number < 0) {
      diagnostics.warn(key.line, section.name + " word", "[" + section.name + "] has a key that is not a number",
                       "ignored; number its lines from 1");
      continue;
    }
    const int index = key.number - base;
    if (index < 0 || index >= count) {
      diagnostics.warn(key.line, section.name + " range",
                       "[" + section.name + "] line " + std::to_string(key.number) + " is beyond the count of " +
                           std::to_string(count),
                       "ignored; raise the count or remove the line");
      continue;
    }
    const WifKey*& before = first[static_cast<size_t>(index)];
    if (before) {
      const std::string what = "[" + section.name + "] line " + std::to_string(key.number) + " is there twice";
      const std::string where = "the first, in line " + std::to_string(before->line + 1);
      if (before->value != key.value)
        diagnostics.warn(key.line, section.name + " twice", what + ", with other values",
                         where + ", was used; remove one");
      else
        diagnostics.add(Severity::kNote, key.line, section.name + " again", what + " with one value",
                        where + ", says the same; kept");
      continue;
    }
    before = &key;
    use(index, key);
  }
}

}  // namespace weftlight::wif
