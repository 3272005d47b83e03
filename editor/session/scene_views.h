#pragma once
// Views of the cloth by name, as edits: kept, gone to, renamed, dropped.

#include <string>
#include <vector>

#include "session/document_view.h"
#include "session/edit.h"
#include "session/names.h"

namespace weftlight::session {

inline constexpr size_t kMaxKeptViews = 200, kLongestViewName = 80;

/// The scene as it is drawn: with the camera of the view, what hangs in it, and its light.
Scene seen_scene(const DocumentView& view, const Design& design);

/// "View 3", which none is called yet.
std::string free_view_name(const Design& design);
/// What the weaver sees now, under a name; one of that name is replaced.
Edit keep_view_edit(const DocumentView& view, std::string name);
/// The camera goes there; the edit is the light and what hangs, where they are others.
MaybeEdit go_to_view(DocumentView& view, const Design& design, const NamedView& to);
/// A row a kept view: its name as it shall be, empty: dropped. Names that are there already get a number.
Edit rename_views_edit(std::vector<std::string> names);

}  // namespace weftlight::session
