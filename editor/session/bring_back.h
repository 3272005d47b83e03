#pragma once
// What a crashed session left, as a document again.

#include "session/document.h"
#include "session/names.h"
#include "session/recovery.h"

namespace weftlight::session {

/// On top of its file, as a step that undo takes back, where that is the file that the work began with. Otherwise, and
/// where there never was one, a document of its own name without a file, which a save asks a place for.
OpenResult bring_back(const LeftWork& left);

/// "today 14:03", "yesterday 9:30", "3 May 2026, 12:00": when a moment was, seen from `now_ns`; both since 1970.
std::string time_in_words(int64_t then_ns, int64_t now_ns);

}  // namespace weftlight::session
