#pragma once
// What is selected in the draft, and what the select tool has in hand: a rectangle being drawn, marks on the
// move, a block to be pasted. No drawing here: select_input.h and selection_draw.h see to the screen.

#include <memory>
#include <optional>
#include <string>

#include "draft/selection_edits.h"
#include "session/document_view.h"
#include "session/edit.h"
#include "session/names.h"
#include "session/user_files.h"

namespace weftlight::session {

std::optional<BitGrid> bit_grid_of(GridId grid);
GridId grid_id_of(BitGrid grid);
/// Treadled drafts show tie-up and treadling, the others their liftplan.
bool is_shown(const Draft& draft, BitGrid grid);

/// The rectangle that holds both cells.
Selection selection_between(BitGrid grid, Cell one, Cell other);
bool holds(const Selection& selection, BitGrid grid, Cell at);
/// (a, b) of one cell to the right (dx) or down (dy) on the screen.
Cell screen_step(BitGrid grid, const Settings& settings, int dx, int dy);

void select_cells(SelectState& state, const Selection& selection);
/// After every change of the design: what is no longer there is no longer selected; a move taken back by undo
/// takes the selection back.
void follow_design(SelectState& state, const Design& design, uint64_t revision);
/// One step back: the block in hand, else the selection. False when there was neither.
bool escape(SelectState& state);

/// Moves the selected marks so that they begin at (a, b), kept inside the grid. Steps of one move come from
/// the same draft (what they passed over comes back) and are one step of undo. `copy`: a new move, which
/// leaves the marks where they were, too.
MaybeEdit move_selection(SelectState& state, const Design& design, int a, int b, bool copy);
/// Ends a drag; marks on the move go home.
MaybeEdit cancel_drag(SelectState& state, const Design& design);
/// The far corner of the selection, by da and db.
void extend_selection(SelectState& state, const Draft& draft, int da, int db);

/// Takes a block in hand, over the grid that it came from or, when that is not shown, over the selected one.
void hold_block(SelectState& state, const Draft& draft, CellBlock block, bool add);
void hold_block_over(SelectState& state, BitGrid grid, Cell at);
/// The block in hand, as it is seen, made into another.
void turn_held_block(SelectState& state, BitMatrix (*turn)(const BitMatrix&));
/// Puts the block down and selects it; `state.notice` says so, and what the loom could not follow. `keep`: it also
/// stays in hand.
MaybeEdit drop_block(SelectState& state, const Design& design, bool keep);

/// "; 3 crossings could not follow: ..." when a block in the drawdown asks more than the threading can do; else
/// empty.
std::string missed_text(const Draft& draft, BitGrid grid, int a, int b, const BitMatrix& cells);
/// The same of so many crossings.
std::string missed_text(int64_t crossings);
/// "8 ends x 4 shafts".
std::string size_text(BitGrid grid, int columns, int rows);
/// What is selected or in hand, and what can be done with it; empty for neither.
std::string selection_text(const SelectState& state);

}  // namespace weftlight::session
