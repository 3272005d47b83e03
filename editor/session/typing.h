#pragma once
// Numbers typed into the grids by a cell cursor: shafts into the threading, treadles into the treadling, each entry one
// step of undo, after which the cursor goes on to the next thread. No keys of a window here, only their names.

#include <optional>
#include <string>
#include <vector>

#include "session/document_view.h"
#include "session/edit.h"
#include "session/names.h"
#include "session/user_files.h"

namespace weftlight::session {

/// Seconds that a number waits for another digit where one could follow: 1 of 12 shafts, but not 2.
inline constexpr double kDigitWaitS = 1.0;

struct TypedKey {
  bool taken = false;            // it means something here
  std::vector<Edit> edits = {};  // each a step of undo
};
/// A key, as menus write it, at a time in seconds. Digits make a number, which is taken once no further digit can
/// follow, after a wait, or with Enter, a comma or a blank; a digit that would lead beyond the last shaft begins the
/// next number. 0 clears the thread and goes on, Delete clears and stays. In tie-up and liftplan a number turns one
/// mark over, and Enter goes on. A comma after a number that was taken already says nothing new. A blank turns the cell
/// over; Tab goes to the next grid.
TypedKey type_key(DocumentView& view, const Design& design, const Settings& settings, const std::string& key,
                  double now_s);
/// The number that waited long enough.
TypedKey type_after_wait(DocumentView& view, const Design& design, double now_s);
/// Until when one waits.
std::optional<double> waits_until(const DocumentView& view);

/// The tool in hand: at the selection, else at the cell under the pointer, else where the cursor was.
void begin_typing(DocumentView& view, const Draft& draft, Hover hover);
void put_cursor(DocumentView& view, GridId grid, Cell at);
/// What is no longer there holds no cursor.
void follow_draft(TypeCursor& cursor, const Draft& draft);

/// What stands at the cursor, and what can be typed.
std::string typing_text(const DocumentView& view, const Design& design, const BitMatrix& cells);

}  // namespace weftlight::session
