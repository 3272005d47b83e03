#pragma once
// Edits only those lines of a file that differ between two sets of entries.

#include <optional>
#include <string>
#include <vector>

#include "wif/design_sections.h"

namespace weftlight::wif {

/// What is written: entries that differ; also every count, and sections that the file lacks; or every entry whose line
/// does not have exactly its value.
enum class EditScope { kChanged, kCounts, kAll };

/// The bytes of `text` with the entries of `now` where they differ from `before`. Empty if the encoding of the file
/// cannot represent them.
std::optional<std::string> patched(const WifText& text, const std::vector<WifEntries>& before,
                                   const std::vector<WifEntries>& now, EditScope scope);

}  // namespace weftlight::wif
