#pragma once
// Named views of the cloth as edits: save, go to, rename, delete.

#include <string>
#include <vector>

#include "session/document/edit.h"
#include "session/editing/cloth_view.h"

namespace weftlight::session {

using design::Design, design::NamedView, design::Scene;

inline constexpr size_t kMaxKeptViews = 200, kLongestViewName = 80;

/// The scene as it is drawn: with the camera of the view, and with the flat swatch and its light if the view is flat.
Scene seen_scene(const ClothView& view, const Design& design);

/// "View 3", an unused name.
std::string free_view_name(const Design& design);
/// Saves the present view under a name; replaces a view of that name.
Edit keep_view_edit(const ClothView& view, std::string name);
/// Moves the camera there. The edit sets the light and the drape if they differ.
MaybeEdit go_to_view(ClothView& view, const Design& design, const NamedView& to);
/// `names` holds one new name per saved view; an empty name deletes it. Duplicate names get a number.
Edit rename_views_edit(std::vector<std::string> names);

}  // namespace weftlight::session
