#pragma once
// Operations of the select tool: a rectangle being drawn, marks being moved, a block being pasted. select_input.h and
// selection_draw.h handle input and drawing.

#include <memory>
#include <optional>
#include <string>

#include "design/selection_edits.h"
#include "session/document/edit.h"
#include "session/editing/document_view.h"
#include "session/files/user_files.h"

namespace weftlight::session {

using design::Design;
using draft::BitGrid, draft::BitMatrix, draft::CellBlock, draft::Draft, draft::Selection;

std::optional<BitGrid> bit_grid_of(GridId grid);
GridId grid_id_of(BitGrid grid);
/// Treadled drafts show tie-up and treadling, the others their liftplan.
bool is_shown(const Draft& draft, BitGrid grid);

/// The rectangle with both cells as corners.
Selection selection_between(BitGrid grid, Cell one, Cell other);
bool holds(const Selection& selection, BitGrid grid, Cell at);
/// The step in (a, b) that is one cell to the right (dx) or down (dy) on the screen.
Cell screen_step(BitGrid grid, const Settings& settings, int dx, int dy);

void select_cells(SelectState& state, const Selection& selection);
/// Called after every change of the design: limits the selection to what still exists; undo of a move moves the
/// selection back.
void follow_design(SelectState& state, const Design& design, uint64_t revision);
/// Drops the active block, else the selection. False if there was neither.
bool escape(SelectState& state);

/// The edit, with the reason if a locked grid takes nothing.
Edit unless_locked(BitGrid grid, Edit edit);

/// Moves the selected marks so that they begin at (a, b), kept inside the grid; those of a locked grid stay. All steps
/// of one move start from the same draft, so that cells passed over are restored, and are one undo step. `copy` starts
/// a new move that also leaves the marks in place.
MaybeEdit move_selection(SelectState& state, const Design& design, int a, int b, bool copy);
/// What of a move in the drawdown could not follow, where it is now and where it was: see missed_text(). Empty if all
/// did, or if nothing was moved.
std::string missed_by_move(const SelectState& state, const Design& design);
/// Ends a drag; `view.select.refusal` reports the crossings that could not follow.
void end_drag(DocumentView& view, const Design& design);
/// Cancels a drag; moved marks return to their origin.
MaybeEdit cancel_drag(SelectState& state, const Design& design);
/// Moves the far corner of the selection by da and db.
void extend_selection(SelectState& state, const Draft& draft, int da, int db);

/// Makes a block active, over the grid that it came from or, if that is hidden, over the selected one.
void hold_block(SelectState& state, const Draft& draft, CellBlock block, bool add);
void hold_block_over(SelectState& state, BitGrid grid, Cell at);
/// Mirrors or rotates the active block as it is seen on the screen.
void turn_held_block(SelectState& state, BitMatrix (*turn)(const BitMatrix&));
/// Pastes the block and selects it; `state.notice` reports it, the shafts and treadles that it added, and the crossings
/// that the loom could not follow. `keep`: the block stays active, as it does over a locked grid.
MaybeEdit drop_block(SelectState& state, const Design& design, bool keep);

/// The crossings of a block in the drawdown, its first cell at (a, b), that the threading cannot weave; 0 in other
/// grids.
int64_t missed_crossings(const Draft& draft, BitGrid grid, int a, int b, const BitMatrix& cells);
/// What was done, with the number of crossings that could not follow: "Paste; 3 crossings could not follow: ...".
std::string missed_text(const std::string& done, int64_t crossings);
/// What was done, with the shafts and treadles that it added: "Paste; 2 treadles added".
std::string with_added(std::string done, const Draft& before, const Draft& after);
/// "8 ends x 4 shafts".
std::string size_text(BitGrid grid, int columns, int rows);
/// Describes the selection or the active block and its keys; empty if there is neither.
std::string selection_text(const SelectState& state);

}  // namespace weftlight::session
