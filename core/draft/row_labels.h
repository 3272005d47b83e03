#pragma once
// Inside of factoring: which threads share a label (ends a shaft, picks a treadle), where a label that threads
// have already stays with them as far as it can.

#include <vector>

#include "draft/bit_matrix.h"

namespace weftlight::draft {

/// Threads of one group weave alike. Vectors are by thread, by label or by group.
struct Labelling {
  std::vector<int> group;      // of each thread; -1: it takes no part
  std::vector<int> first;      // of each group: its first thread
  std::vector<int> old_label;  // of each thread; -1: none
  std::vector<int> meaning;    // of each label: the group that weaves as it did; -1: none does
  std::vector<char> fixed;     // of each label: its meaning may not change
  std::vector<char> empty;     // of each label: it has no meaning that would be lost
  std::vector<int> owner;      // of each label: the group that has it; -1: none
  std::vector<int> label_of;   // of each group: its label with the most threads
  int groups() const { return static_cast<int>(first.size()); }
  int labels() const { return static_cast<int>(owner.size()); }
  /// The label a thread gets: its old one where that is still its group's.
  int label(int thread) const;
};

/// Groups of the rows of `threads` that take part; `meanings`: a row of the same width a label.
Labelling labelling_of(const BitMatrix& threads, const std::vector<char>& takes_part, const BitMatrix& meanings);

/// Gives every group a label, of `most` at the most; false when there are too few.
bool give_labels(Labelling& l, int most);

}  // namespace weftlight::draft
