#pragma once
// A journal: what one document with unsaved work said, entry after entry, so that the last whole one can be brought
// back. Appended to only; a torn tail (a crash, a full disk) costs the entries that are torn and no others.
//
// An entry is the whole text that a save would write, as the difference to the entry before. Of a draft of 1285 ends
// and 3058 picks that text is 80 to 200 KB and takes 2 to 4 ms of one core to make; a painted cell then takes some
// forty bytes. The difference of two designs would be no smaller, would need a format of its own, and would not hold
// what the opened file says beside its draft.

#include <optional>
#include <string>
#include <string_view>

#include "session/file_identity.h"
#include "session/names.h"

namespace weftlight::session {

/// What a journal says of its document beside the text.
struct DocumentNote {
  std::string path;   // of the file that it was opened from or saved to; empty: none yet
  std::string name;   // as the window showed it: "twill.wif", "Untitled"
  FileIdentity file;  // of the file at `path`, when it was read or written
  bool operator==(const DocumentNote&) const = default;
};

struct JournalEntry {
  DocumentNote note;
  std::string text;  // WIF
};

/// Of a text, and of the memory that reading a journal may take; far above any draft (draft.h).
inline constexpr size_t kMaxJournalText = size_t{256} << 20;

/// The beginning of a journal: a whole entry.
std::string journal_start(const JournalEntry& entry);
/// What is appended when the text was `before` and is `now`.
std::string journal_entry(std::string_view before, std::string_view now);

/// The last whole entry; none when there is not even one.
std::optional<JournalEntry> read_journal(std::string_view bytes);

}  // namespace weftlight::session
