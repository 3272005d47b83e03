#pragma once
// Changing a file's lines: only those that differ between two sets of entries.

#include <optional>
#include <string>
#include <vector>

#include "wif/names.h"
#include "wif/sections.h"

namespace weftlight::wif {

/// How much is put in the file: what differs; also every count and every section the file lacks; or every
/// entry that its line does not say word for word.
enum class Reach { kChanged, kCounts, kAll };

/// The bytes of `text` with the entries of `now` where they differ from those of `before`. Empty when the
/// file's encoding cannot hold them.
std::optional<std::string> patched(const WifText& text, const std::vector<WifEntries>& before,
                                   const std::vector<WifEntries>& now, Reach reach);

}  // namespace weftlight::wif
