#pragma once
// A block of cells as plain text, so that the system's clipboard carries it between windows and programs.
//
//   weftlight cells: threading, 4 x 2
//   #.#.
//   .#.#
//
// One line a row b, one character a column a, both from the lowest: pick 1 (shaft 1) first, end 1 first, as
// `weftlight drawdown` writes. The first line may be missing: then # X x * 1 are marks, . 0 - _ and a space
// between others are none, and the text is taken for crossings.

#include <optional>
#include <string>
#include <string_view>

#include "draft/selection.h"

namespace weftlight::draft {

/// Most cells that a text may hold; a display's clipboard takes no more than a few million bytes.
inline constexpr int64_t kMaxBlockCells = int64_t{1} << 22;

struct BlockRead {
  std::optional<CellBlock> block;
  std::string problem;  // why there is none
};

/// Empty when the block has no cells or more than kMaxBlockCells.
std::string block_text(const CellBlock& block);
/// Any bytes. Rows of different lengths are filled up with empty cells; any line ends.
BlockRead read_block_text(std::string_view text);

/// "threading", "tieup", ... as in the first line.
const char* bit_grid_name(BitGrid grid);

}  // namespace weftlight::draft
