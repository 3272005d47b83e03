#pragma once
// Iterates over the numbered rows of a data section.

#include <string>
#include <vector>

#include "base/text.h"
#include "wif/numbers.h"
#include "wif/parse.h"

namespace weftlight::wif {

/// 0 if the rows count from 0: row 0 has a value and there is no row `count`; otherwise 1.
int row_base(const WifSection& section, int count);

/// Notes a list that ends before the last thread; `rest` is what those without a line are given. A list without lines
/// is none.
void note_short_list(const WifSection& section, int count, Diagnostics& diagnostics, const std::string& rest);

/// Calls use(index, key) for each numbered row with a value; index is 0-based and less than `count`. Of equal keys the
/// first is used; the others and rows out of range are reported.
template <class Use>
void each_row(const WifSection& section, int count, int base, Diagnostics& diagnostics, Use use) {
  std::vector<const WifKey*> first(static_cast<size_t>(count), nullptr);
  for (const WifKey& key : section.keys) {
    if (key.value.empty()) continue;
    if (key.number < 0) {
      diagnostics.warn(
          key.line, section.name + " word",
          base::fill(base::tr("[{section}] has a key that is not a number"), base::arg("section", section.name)),
          base::tr("ignored; number its lines from 1"));
      continue;
    }
    const int index = key.number - base;
    if (index < 0 || index >= count) {
      diagnostics.warn(
          key.line, section.name + " range",
          base::fill(base::tr("[{section}] line {number} is beyond the count of {count}"),
                     base::arg("section", section.name), base::arg("number", key.number), base::arg("count", count)),
          base::tr("ignored; raise the count or remove the line"));
      continue;
    }
    const WifKey*& before = first[static_cast<size_t>(index)];
    if (before) {
      const auto text = [&](const char* pattern) {
        return base::fill(pattern, base::arg("section", section.name), base::arg("number", key.number),
                          base::arg("line", before->line + 1));
      };
      if (before->value != key.value)
        diagnostics.warn(key.line, section.name + " twice",
                         text(base::tr("[{section}] line {number} appears twice, with different values")),
                         text(base::tr("the first, in line {line}, was used; remove one")));
      else
        diagnostics.add(Severity::kNote, key.line, section.name + " again",
                        text(base::tr("[{section}] line {number} appears twice, with the same value")),
                        text(base::tr("the first is in line {line}; both are kept")));
      continue;
    }
    before = &key;
    use(index, key);
  }
}

}  // namespace weftlight::wif
