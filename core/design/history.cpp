#include "design/history.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace weftlight::design {

using draft::BitMatrix, draft::Draft, draft::Rgb, draft::Threads;

namespace {

size_t bytes(const BitMatrix& m) { return static_cast<size_t>(m.rows()) * m.words() * sizeof(uint64_t); }

size_t bytes(const Threads& t) { return static_cast<size_t>(t.size()) * (2 * sizeof(int) + 2 * sizeof(float)); }

size_t bytes(const Design& design) {
  const Draft& d = design.draft;
  size_t sum = sizeof(Design) + bytes(d.threading) + bytes(d.tieup) + bytes(d.treadling) + bytes(d.liftplan) +
               bytes(d.warp) + bytes(d.weft) + d.palette.size() * sizeof(Rgb) + design.yarns.size() * sizeof(Yarn);
  for (const WeaveUse& use : design.weaves) {
    sum += sizeof(WeaveUse);
    for (const auto& [id, value] : use.values) sum += 2 * sizeof(std::string) + value.size();
  }
  for (const NamedView& view : design.views) sum += sizeof(NamedView) + view.name.size() + view.scene.mesh.size();
  for (const Assembly* assembly : {&design.warp_assembly, &design.weft_assembly})
    for (const ThreadSection& section : assembly->sections)
      sum += sizeof(ThreadSection) + bytes(section.rows) + bytes(section.threads);
  for (const std::string& note : design.notes) sum += sizeof(std::string) + note.size();
  return sum;
}

}  // namespace

History::History(Design first) {
  const size_t size = bytes(first);
  steps_.push_back({std::make_shared<const Design>(std::move(first)), {}, 0, 0, size});
  total_bytes_ = size;
}

void History::commit(Design next, std::string label, uint64_t stroke) {
  if (next == now()) return;
  drop_redo();
  const bool joins = stroke != 0 && position_ > 0 && steps_[position_].stroke == stroke;
  if (joins) {
    label = std::move(steps_[position_].label);
    drop_last();
    if (next == now()) return;  // the stroke reverted itself
  }
  const size_t size = bytes(next);
  steps_.push_back({std::make_shared<const Design>(std::move(next)), std::move(label), stroke, next_id_++, size});
  total_bytes_ += size;
  position_ = steps_.size() - 1;
  drop_oldest();
}

void History::drop_redo() {
  while (steps_.size() > position_ + 1) {
    total_bytes_ -= steps_.back().bytes;
    steps_.pop_back();
  }
}

void History::drop_last() {
  total_bytes_ -= steps_.back().bytes;
  steps_.pop_back();
  position_ = steps_.size() - 1;
}

void History::drop_oldest() {
  size_t dropped = 0;
  while (total_bytes_ > kMaxHistoryBytes && steps_.size() - dropped > 2) {
    total_bytes_ -= steps_[dropped++].bytes;
  }
  steps_.erase(steps_.begin(), steps_.begin() + static_cast<std::ptrdiff_t>(dropped));
  position_ -= dropped;
}

void History::undo() {
  if (can_undo()) --position_;
}

void History::redo() {
  if (can_redo()) ++position_;
}

void History::go_to(size_t step) { position_ = std::min(step, steps_.size() - 1); }

std::string History::undo_label() const { return can_undo() ? steps_[position_].label : std::string(); }

std::string History::redo_label() const { return can_redo() ? steps_[position_ + 1].label : std::string(); }

void History::mark_unsaved() { saved_id_ = std::numeric_limits<uint64_t>::max(); }

bool History::is_saved() const { return is_saved(position_); }

}  // namespace weftlight::design
