#pragma once
// What differs between two drafts, for people and for scripts.

#include <string>
#include <vector>

#include "analysis/names.h"
#include "draft/design.h"
#include "draft/drawdown.h"

namespace weftlight::analysis {

struct Difference {
  std::string what;          // "threading", "tie-up", "warp colours", "title", ...
  std::string a, b;          // as each says it, where that is short
  std::vector<int> threads;  // 0-based ends, treadles or picks that differ, where they are counted
};

struct Comparison {
  std::vector<Difference> differences;  // empty: the designs are the same
  bool same_cloth = false;              // drawdowns of the same size and the same in every crossing
  int64_t crossings = 0;                // that differ, in the part both have
  CellRect where;                       // holds them all
};
Comparison compare(const Design& a, const Design& b);

/// picks x ends of `x`: crossings that are others in `y`; what only one of them has is none.
BitMatrix differing_crossings(const BitMatrix& x, const BitMatrix& y);
/// Where those are: runs of neighbouring ends, then of picks, each crossing with the thread of which more differ; at
/// most `most` of them.
std::vector<CellRect> differing_regions(const BitMatrix& differing, size_t most);

/// "end 3, picks 5-8": the shorter side first.
std::string region_text(const CellRect& place);
/// "1-4, 7, 9-12" of 0-based threads, counted from 1.
std::string thread_list(const std::vector<int>& threads);

}  // namespace weftlight::analysis
