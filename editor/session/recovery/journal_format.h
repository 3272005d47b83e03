#pragma once
// Format of a journal: the states of one unsaved document, entry by entry, so that the last complete one can be
// recovered. Journals are only appended to; a torn tail (crash, full disk) costs only the torn entries.
//
// An entry is the whole text that a save would write, as a difference from the entry before. Of a draft of 1285 ends
// and 3058 picks that text is 80 to 200 KB and takes 2 to 4 ms of one core to make; a painted cell then takes some
// forty bytes. A difference of two designs would be no smaller, would need its own format, and would not hold the other
// sections of the opened file.

#include <optional>
#include <string>
#include <string_view>

#include "session/files/file_identity.h"

namespace weftlight::session {

/// Describes the document of a journal.
struct DocumentNote {
  std::string path;   // of the file that it was opened from or saved to; empty if none
  std::string name;   // as the window showed it: "twill.wif", "Untitled"
  FileIdentity file;  // of the file at `path`, when it was read or written
  bool operator==(const DocumentNote&) const = default;
};

struct JournalEntry {
  DocumentNote note;
  std::string text;  // WIF
};

/// Limit of a text, and of the memory that reading a journal may take; far above any draft (draft.h).
inline constexpr size_t kMaxJournalText = size_t{256} << 20;

/// The start of a journal: the magic line and a complete entry.
std::string journal_start(const JournalEntry& entry);
/// The entry to append when the text changes from `before` to `now`.
std::string journal_entry(std::string_view before, std::string_view now);

/// The last complete entry, if there is one.
std::optional<JournalEntry> read_journal(std::string_view bytes);

}  // namespace weftlight::session
