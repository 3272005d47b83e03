#pragma once
// A block of cells as plain text, for the clipboard.
//
//   weftlight cells: threading, 4 x 2
//   #.#.
//   .#.#
//
// One line per row b, one character per column a, in ascending order: pick 1 (shaft 1) first, end 1 first, as
// `weftlight drawdown` writes. Without the first line the text is read as crossings. # X x * 1 are marks; . 0 - _ and
// blanks are empty cells. Cells may be parted by blanks, or by tabs as in a spreadsheet, whose empty cells have no
// text.

#include <string>
#include <string_view>

#include "base/result.h"
#include "draft/selection.h"

namespace weftlight::draft {

/// Limit of a text: a clipboard takes no more than a few million bytes.
inline constexpr int64_t kMaxBlockCells = int64_t{1} << 22;

/// Empty when the block has no cells or more than kMaxBlockCells.
std::string block_text(const CellBlock& block);
/// Accepts any bytes and any line ends. Short rows are filled up with empty cells.
base::Result<CellBlock> read_block_text(std::string_view text);

/// "threading", "tieup", ... as in the first line of the text.
const char* bit_grid_name(BitGrid grid);

}  // namespace weftlight::draft
