#pragma once
// Deleting colours and yarns of the draft: what takes their place, in words; and the active ones, which keep their
// place in the lists by what they are.

#include <functional>
#include <string>

#include "design/palette_edits.h"
#include "session/document/document.h"
#include "session/editing/drawing_state.h"

namespace weftlight::session {

/// Runs an edit of the lists. The active colour and yarn are the same afterwards, if they are still there.
void keeping_active(DrawingState& drawing, const Document& document, const std::function<void()>& edit);

/// A colour or yarn to delete, and what takes its place.
struct Deletion {
  int entry = 0, heir = 0;
  int ends = 0, picks = 0, in_sections = 0;  // threads that have it
  bool is_used() const { return ends + picks + in_sections > 0; }
};
Deletion color_deletion(const Design& design, int color);
Deletion yarn_deletion(const Design& design, int yarn);
/// "It is used by 12 ends and 4 picks. Colour 5, the closest one, takes its place."
std::string color_deletion_words(const Deletion& deletion);
std::string yarn_deletion_words(const Design& design, const Deletion& deletion);

Edit delete_color_edit(const Deletion& deletion);
Edit delete_yarn_edit(const Design& design, const Deletion& deletion);

}  // namespace weftlight::session
