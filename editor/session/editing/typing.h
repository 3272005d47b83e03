#pragma once
// Number entry into the grids at a cell cursor: shafts into the threading, treadles into the treadling. Each entry is
// one undo step, after which the cursor moves to the next thread. Keys are given by name.

#include <optional>
#include <string>
#include <vector>

#include "session/document/edit.h"
#include "session/editing/document_view.h"
#include "session/files/user_files.h"

namespace weftlight::session {

using design::Design;
using draft::BitMatrix, draft::Draft;

/// Seconds that a number waits for another digit if one could follow: with 12 shafts 1 waits, 2 does not.
inline constexpr double kDigitWaitS = 1.0;

struct TypedKey {
  bool taken = false;            // the key was used
  std::vector<Edit> edits = {};  // each one undo step
};
/// Handles a key, named as in menus, at a time in seconds. Digits make a number, which is accepted once no further
/// digit can follow, after a wait, or with Enter, comma or Space; a digit that would exceed the last shaft starts the
/// next number. 0 clears the thread and moves on, Delete clears and stays. In tie-up and liftplan a number toggles one
/// mark, and Enter moves on. A comma after an accepted number is ignored. Space toggles the cell; Tab goes to the next
/// grid.
TypedKey type_key(DocumentView& view, const Design& design, const Settings& settings, const std::string& key,
                  double now_s);
/// Accepts a number that waits for another digit, before the cursor or the tool is changed by other means than a key.
MaybeEdit accept_number(DocumentView& view, const Design& design);
/// Accepts a number that has waited long enough.
TypedKey type_after_wait(DocumentView& view, const Design& design, double now_s);
/// Time in seconds until which a number waits.
std::optional<double> waits_until(const DocumentView& view);

/// Starts the tool at the selection, else at the cell under the pointer, else at the old cursor.
void begin_typing(DocumentView& view, const Draft& draft, Hover hover);
void put_cursor(TypeCursor& cursor, GridId grid, Cell at);
/// Keeps the cursor inside the shown grids.
void follow_draft(TypeCursor& cursor, const Draft& draft);

/// Describes the cell at the cursor and the keys.
std::string typing_text(const TypeCursor& cursor, const Design& design, const BitMatrix& cells);

}  // namespace weftlight::session
