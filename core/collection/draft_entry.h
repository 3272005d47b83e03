#pragma once
// What a list of drafts knows of a file without opening it again.

#include <cstdint>
#include <string>
#include <string_view>

#include "analysis/weave_family.h"

namespace weftlight::collection {

using analysis::WeaveFamily;

struct DraftEntry {
  std::string path;
  uint64_t size = 0;        // bytes
  int64_t modified_ns = 0;  // since 1970
  bool readable = false;    // otherwise the rest is empty
  int ends = 0, picks = 0, shafts = 0;
  int treadles = 0;  // 0 with a liftplan
  WeaveFamily family = WeaveFamily::kOther;
  uint32_t colours = 0;  // bits by colour_names.h
  std::string title;     // UTF-8, as the file has it; may be empty
  std::string author;
  std::string found_by;  // title, author and path in small letters; for searching, made by with_search_text()
  bool operator==(const DraftEntry&) const = default;
};

/// What the bytes of a draft say; path, size and time stay as they are given. Unreadable bytes make an unreadable
/// entry.
DraftEntry entry_of(DraftEntry file, std::string_view bytes);
DraftEntry with_search_text(DraftEntry entry);
/// The title, or else the name of the file without its ending.
std::string shown_name(const DraftEntry& entry);

}  // namespace weftlight::collection
