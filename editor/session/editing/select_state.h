#pragma once
// The state of the select tool in a document's view; its operations are in selection_state.h.

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "draft/selection.h"
#include "session/editing/grid.h"

namespace weftlight::session {

using design::Design;
using draft::BitGrid, draft::CellBlock, draft::Selection;

enum class Tool { kPaint, kSelect, kLine, kRectangle, kFilledRectangle, kFill, kType };
enum class SelectDrag { kNone, kBand, kMove };

/// A move of marks in progress: the design before it, and their origin.
struct MarksOnTheMove {
  std::shared_ptr<const Design> base;
  Selection from;
  bool copy = false;
  uint64_t stroke = 0;  // the steps of the move are one undo step
};

/// A block being pasted, its first cell at `at`.
struct ActiveBlock {
  CellBlock block;
  BitGrid grid = BitGrid::kThreading;
  Cell at{0, 0};
  bool add = false;  // adds its marks without clearing others
};

struct SelectState {
  Tool tool = Tool::kPaint;
  Selection selected;           // empty if nothing is selected
  Cell anchor;                  // first corner of the selection
  bool with_properties = true;  // moving whole threads moves their colours and yarns
  SelectDrag drag = SelectDrag::kNone;
  Cell grip;  // of a move: the cell under the pointer, relative to the first of the selection
  std::optional<MarksOnTheMove> move;
  std::optional<ActiveBlock> held;
  std::string notice;     // shown once in the status line
  std::string refusal;    // the same: what could not be done
  uint64_t revision = 0;  // of the design last followed
  uint64_t moves = 0;     // number of moves so far
};

}  // namespace weftlight::session
