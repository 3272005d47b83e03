#pragma once
// The index of a folder as the text of a file in the cache: a heading, then a line for each draft, its fields between
// tabs.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "collection/draft_entry.h"

namespace weftlight::collection {

inline constexpr size_t kMaxIndexed = 500'000;  // drafts

std::string index_text(const std::vector<DraftEntry>& entries);
/// Empty if it is no index of this version, or is damaged: it is then made anew. Any bytes can be read.
std::optional<std::vector<DraftEntry>> entries_from(std::string_view text);

}  // namespace weftlight::collection
