#pragma once
// Undo: a list of immutable snapshots of the Design with labels. One drag is one step
// (commits with the same stroke id join). The saved mark is a position in the list.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "draft/design.h"

namespace weftlight::draft {

/// What the snapshots may take together; past it the oldest steps go, but never the last one.
inline constexpr size_t kMaxHistoryBytes = size_t{256} << 20;

class History {
 public:
  /// `first` counts as saved.
  explicit History(Design first);

  const Design& now() const { return *steps_[position_].design; }
  std::shared_ptr<const Design> snapshot() const { return steps_[position_].design; }
  /// Equal designs make no step. A non-zero `stroke` joins the step before if it has the same stroke.
  void commit(Design next, std::string label, uint64_t stroke = 0);
  bool can_undo() const { return position_ > 0; }
  bool can_redo() const { return position_ + 1 < steps_.size(); }
  void undo();
  void redo();
  /// The steps that undo and redo walk along: the first is the oldest design that is kept, which no edit made.
  size_t steps() const { return steps_.size(); }
  size_t position() const { return position_; }
  /// What made the design of a step; empty of the first.
  const std::string& label(size_t step) const { return steps_[step].label; }
  bool is_saved(size_t step) const { return steps_[step].id == saved_id_; }
  /// As many undos or redos as lead there.
  void go_to(size_t step);
  /// Label of the step that undo (redo) would take back (bring again); empty if none.
  std::string undo_label() const;
  std::string redo_label() const;
  void mark_saved();
  /// No step is what was saved.
  void mark_unsaved();
  bool is_saved() const;

 private:
  struct Step {
    std::shared_ptr<const Design> design;
    std::string label;
    uint64_t stroke = 0;
    uint64_t id = 0;
    size_t bytes = 0;
  };
  void drop_redo();
  void drop_last();
  void drop_oldest();
  std::vector<Step> steps_;
  size_t position_ = 0, total_bytes_ = 0;
  uint64_t next_id_ = 1, saved_id_ = 0;
};

}  // namespace weftlight::draft
