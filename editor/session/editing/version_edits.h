#pragma once
// Versions of the draft as edits: keep, go to, rename, delete. Each is one step of undo.

#include <cstddef>
#include <string>

#include "design/versions.h"
#include "session/document/edit.h"

namespace weftlight::session {

using design::Version;

/// Keeps the draft as it is now; a version of that name is replaced.
Edit keep_version_edit(const std::string& name);
/// The draft as the version keeps it. Empty if it is that already.
MaybeEdit go_to_version_edit(const Design& design, const Version& version);
Edit rename_version_edit(size_t version, const std::string& name);
Edit delete_version_edit(const Design& design, size_t version);

/// The version after (step 1) or before (-1) the one that the draft is now, going round; of a draft that is none of
/// them, the first or the last. Null without versions.
const Version* next_version(const Design& design, int step);

/// What tells a version from the draft as it is now, in the user's language: "other colours".
std::string version_words(const Design& now, const Version& version);

}  // namespace weftlight::session
