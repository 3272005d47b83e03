#pragma once
// Internal to factoring: assigns a label to each thread (a shaft to each end, a treadle to each pick), keeping the
// labels that threads have already where possible.

#include <vector>

#include "draft/bit_matrix.h"

namespace weftlight::draft {

/// Threads of one group weave alike. Vectors are indexed by thread, by label or by group.
struct Labelling {
  std::vector<int> group;      // of each thread; -1: not labelled
  std::vector<int> first;      // of each group: first thread
  std::vector<int> old_label;  // of each thread; -1: none
  std::vector<int> meaning;    // of each label: the group that weaves as the label did before; -1: none
  std::vector<char> fixed;     // of each label: may not get another meaning
  std::vector<char> empty;     // of each label: unused, free to take
  std::vector<int> owner;      // of each label: group it is assigned to; -1: none
  std::vector<int> label_of;   // of each group: its label with most threads
  int groups() const { return static_cast<int>(first.size()); }
  int labels() const { return static_cast<int>(owner.size()); }
  /// The label of a thread: its old one if that still belongs to its group.
  int label(int thread) const;
};

/// Groups the threads that take part and have equal rows. row_of: of each thread, its row of `rows`. `meanings`: of
/// each label, a row of the same width.
Labelling labelling_of(const BitMatrix& rows, const std::vector<int>& row_of, const std::vector<char>& takes_part,
                       const BitMatrix& meanings);

/// Assigns a label to every group, at most `most` labels in all; false if that is too few.
bool assign_labels(Labelling& l, int most);

}  // namespace weftlight::draft
