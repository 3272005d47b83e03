#pragma once
// Reopens the unsaved work of a crashed session as a document.

#include "session/document/document.h"
#include "session/recovery/recovery.h"

namespace weftlight::session {

/// If the file is still the one that the work began with, it is opened and the work is one undoable step on top of it.
/// Otherwise, or if there never was a file, the result is a document without a file, under its old name.
OpenResult bring_back(const LeftWork& left);

/// The name of its document, for people; of unreadable work the path of its journal.
std::string name_of(const LeftWork& left);

/// "today 14:03", "yesterday 9:30", "3 May 2026, 12:00": a time as seen from `now_ns`; both in ns since 1970.
std::string time_in_words(int64_t then_ns, int64_t now_ns);

}  // namespace weftlight::session
