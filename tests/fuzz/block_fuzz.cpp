// Any bytes on the clipboard: parsing never crashes, a block survives writing and reading, and a draft stays consistent
// wherever it is pasted.

#include <cstdint>
#include <string_view>

#include "design/selection_edits.h"
#include "draft/block_text.h"
#include "require.h"

using weftlight::design::Design, weftlight::design::is_consistent, weftlight::design::with_block;
using weftlight::draft::BitGrid, weftlight::draft::CellBlock, weftlight::draft::Write, weftlight::draft::blank_draft,
    weftlight::draft::block_text, weftlight::draft::is_consistent, weftlight::draft::read_block_text,
    weftlight::draft::turned_for;

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  const weftlight::base::Result<CellBlock> read = read_block_text({reinterpret_cast<const char*>(data), size});
  require(read || !read.error().text.empty(), "a rejection has a reason");
  if (!read) return 0;
  const CellBlock& block = *read;
  require(block.cells.rows() > 0 && block.cells.cols() > 0, "a block has cells");
  require(*read_block_text(block_text(block)) == block, "a block survives writing and reading");
  Design design;
  design.draft = blank_draft(9, 7, 4, 5);
  for (int end = 0; end < 9; ++end) design.draft.threading.set(end, end % 4, true);
  for (BitGrid grid : {BitGrid::kThreading, BitGrid::kTieup, BitGrid::kTreadling, BitGrid::kDrawdown}) {
    const int a = static_cast<int>(size % 13) - 4, b = static_cast<int>(data[0] % 11) - 3;
    design = with_block(std::move(design), grid, a, b, turned_for(block, grid),
                        size % 2 == 0 ? Write::kThreads : Write::kAdd);
    require(is_consistent(design), "a draft stays consistent");
  }
  return 0;
}
