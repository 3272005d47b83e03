#pragma once
// Tabby: the two sheds of plain weave that a threading can give, woven between pattern picks.

#include <cstdint>
#include <optional>
#include <vector>

#include "draft/draft.h"

namespace weftlight::loom {

using draft::Draft;

/// Shafts of each shed, from 0, ascending: the first carry ends 1, 3, 5 ..., the second ends 2, 4, 6 ...
struct TabbySheds {
  std::vector<int> first, second;
  bool operator==(const TabbySheds&) const = default;
};
/// Nothing if a shaft carries ends of both, or one of the two sheds carries none.
std::optional<TabbySheds> tabby_sheds(const Draft& draft);

/// The treadles of the tie-up that open this shed, from 0: one, else two pressed together. Empty if there are none, or
/// the draft has no treadles. Shafts without ends do not count.
std::vector<int> treadles_of_shed(const Draft& draft, const TabbySheds& sheds, bool second);

}  // namespace weftlight::loom
