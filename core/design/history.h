#pragma once
// Undo: a list of labelled steps of the Design, each kept as its difference from the one before: painted cells take a
// few bytes, anything else both designs. One drag is one step: commits with the same stroke id are merged. The saved
// mark is a position in the list. The place at the loom is no part of it: it is where the weaver is, whatever is
// undone.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "design/design.h"

namespace weftlight::design {

/// Memory limit of all steps; beyond it the oldest steps are dropped, but never the last one.
inline constexpr size_t kMaxHistoryBytes = size_t{256} << 20;

class History {
 public:
  /// `first` counts as saved.
  explicit History(Design first);

  const Design& now() const { return *now_; }
  std::shared_ptr<const Design> snapshot() const { return now_; }
  /// A design equal to now() makes no step. A non-zero `stroke` replaces the step before if that has the same stroke.
  /// What only moves the place at the loom makes no step either; any other edit leaves the place.
  void commit(Design next, std::string label, uint64_t stroke = 0);
  bool can_undo() const { return position_ > 0; }
  bool can_redo() const { return position_ + 1 < steps_.size(); }
  void undo();
  void redo();
  /// Steps for undo and redo. The first is the oldest design that is kept; it has no label.
  size_t steps() const { return steps_.size(); }
  size_t position() const { return position_; }
  /// Label of the edit that made a step; empty for the first.
  const std::string& label(size_t step) const { return steps_[step].label; }
  bool is_saved(size_t step) const;
  /// Undoes or redoes to a step.
  void go_to(size_t step);
  /// Label of the step that undo would revert, or redo repeat; empty if there is none.
  std::string undo_label() const;
  std::string redo_label() const;
  /// Memory of all steps, as kMaxHistoryBytes counts it.
  size_t kept_bytes() const { return total_bytes_; }
  /// A step, and the place at the loom.
  struct Mark {
    uint64_t step = 0;
    Loom place;  // of it the place only
    bool operator==(const Mark&) const = default;
  };
  /// Names the present for mark_saved().
  Mark mark() const;
  void mark_saved() { mark_saved(mark()); }
  /// That step counts as saved while the weaver is at that place, the present one only if it still is the same. No
  /// other does any more.
  void mark_saved(const Mark& mark) { saved_ = mark; }
  /// No step counts as saved any more.
  void mark_unsaved();
  bool is_saved() const;

 private:
  struct Change;
  struct Step {
    std::shared_ptr<const Change> change;  // from the step before; null for the first
    std::string label;
    uint64_t stroke = 0;
    uint64_t id = 0;
    size_t bytes = 0;
  };
  std::shared_ptr<const Design> at(size_t step) const;
  Step step_to(size_t before, const std::shared_ptr<const Design>& from, const std::shared_ptr<const Design>& to) const;
  void drop_after(size_t step);
  void drop_oldest();
  std::shared_ptr<const Design> now_;
  std::vector<Step> steps_;
  size_t position_ = 0, total_bytes_ = 0;
  uint64_t next_id_ = 1;
  Mark saved_;
};

}  // namespace weftlight::design
