#pragma once
// The differences of two drafts, for users and for scripts.

#include <string>
#include <vector>

#include "design/design.h"
#include "draft/drawdown.h"

namespace weftlight::analysis {

using design::Design;
using draft::BitMatrix, draft::CellRect;

struct Difference {
  std::string what;          // English: "threading", "tie-up", "warp colours", "title" ...; show tr(what)
  std::string a, b;          // the two values, where they are short; in the user's language
  std::vector<int> threads;  // 0-based ends, treadles or picks that differ
};

struct Comparison {
  std::vector<Difference> differences;  // empty: the designs are the same
  bool same_cloth = false;              // the drawdowns are equal
  int64_t crossings = 0;                // that differ, among those that both have
  CellRect where;                       // bounding box of those crossings
};
Comparison compare(const Design& a, const Design& b);

/// picks x ends of `x`: the crossings that differ in `y`. A crossing that only one of them has does not count.
BitMatrix differing_crossings(const BitMatrix& x, const BitMatrix& y);
/// Rectangles around them, at most `most`: runs of neighbouring ends, then of picks. Each crossing belongs to that of
/// its two threads on which more crossings differ.
std::vector<CellRect> differing_regions(const BitMatrix& differing, size_t most);

/// "end 3, picks 5-8": the system with fewer threads first.
std::string region_text(const CellRect& region);
/// "1-4, 7, 9-12", counted from 1; `threads` are 0-based.
std::string thread_list(const std::vector<int>& threads);

}  // namespace weftlight::analysis
