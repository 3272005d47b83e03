#pragma once
// The select tool's part of a document's view; what can be done with it is in selection.h.

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "draft/selection.h"
#include "session/names.h"

namespace weftlight::session {

/// A cell: a is along the screen's x, b along its y. threading (end, shaft), tieup (treadle, shaft),
/// treadling (treadle, pick), liftplan (shaft, pick), drawdown (end, pick), warp_colors (end, 0),
/// weft_colors (0, pick). -1: none.
struct Cell {
  int a = -1, b = -1;
  bool valid() const { return a >= 0 && b >= 0; }
  bool operator==(const Cell&) const = default;
};

enum class Tool { kPaint, kSelect, kLine, kRectangle, kFilledRectangle, kFill, kType };
enum class SelectDrag { kNone, kBand, kMove };

/// Marks on their way: the design that they left from, and from where.
struct MarksOnTheMove {
  std::shared_ptr<const Design> base;
  Selection from;
  bool copy = false;
  uint64_t stroke = 0;  // joins the steps of the move
};

/// A block to be pasted, its first cell over cell `at`.
struct ActiveBlock {
  CellBlock block;
  BitGrid grid = BitGrid::kThreading;
  Cell at{0, 0};
  bool add = false;  // only its marks
};

struct SelectState {
  Tool tool = Tool::kPaint;
  Selection selected;           // empty: nothing
  Cell anchor;                  // where it began
  bool with_properties = true;  // whole threads take their colours along
  SelectDrag drag = SelectDrag::kNone;
  Cell grip;  // of a move: the cell under the pointer, counted from the selection's first
  std::optional<MarksOnTheMove> move;
  std::optional<ActiveBlock> held;
  std::string notice;     // to be said once in the status line
  uint64_t revision = 0;  // of the design last looked at
  uint64_t moves = 0;     // so far
};

}  // namespace weftlight::session
