#pragma once
// Searching a list of drafts.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "collection/draft_entry.h"

namespace weftlight::collection {

/// From `least` to `most`; most 0: no limit.
struct Span {
  int least = 0, most = 0;
  bool any() const { return least <= 0 && most <= 0; }
  bool has(int value) const { return value >= least && (most <= 0 || value <= most); }
  bool operator==(const Span&) const = default;
};
/// "8", "4-8", "8-" or "-8". Empty if it cannot be read.
std::optional<Span> span_from(std::string_view text);

struct DraftQuery {
  std::string words{};  // each of them is in the title, the author or the path; ASCII letters of either case
  Span shafts{}, treadles{}, ends{};
  std::optional<WeaveFamily> family{};
  uint32_t colours = 0;  // all of these bits (colour_names.h)
  bool operator==(const DraftQuery&) const = default;
};

/// Indices of the drafts that have all that is asked for. Unreadable ones are found by words alone.
std::vector<int> found_drafts(const std::vector<DraftEntry>& entries, const DraftQuery& query);

}  // namespace weftlight::collection
