#include "design/history.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>
#include <limits>
#include <span>
#include <type_traits>
#include <utility>

#include "design/loom.h"

namespace weftlight::design {

using draft::BitMatrix, draft::Draft, draft::Rgb, draft::Threads;

namespace {

size_t bytes(const BitMatrix& m) { return static_cast<size_t>(m.rows()) * m.words() * sizeof(uint64_t); }

size_t bytes(const Threads& t) { return static_cast<size_t>(t.size()) * (2 * sizeof(int) + 2 * sizeof(float)); }

size_t bytes(const Design& design) {
  const Draft& d = design.draft;
  size_t sum = sizeof(Design) + bytes(d.threading) + bytes(d.tieup) + bytes(d.treadling) + bytes(d.liftplan) +
               bytes(d.warp) + bytes(d.weft) + d.palette.size() * sizeof(Rgb);
  for (const Yarn& yarn : design.yarns) sum += sizeof(Yarn) + yarn.dye.stretches.size() * sizeof(DyedStretch);
  for (const WeaveUse& use : design.weaves) {
    sum += sizeof(WeaveUse);
    for (const auto& [id, value] : use.values) sum += 2 * sizeof(std::string) + value.size();
  }
  for (const NamedView& view : design.views) sum += sizeof(NamedView) + view.name.size() + view.scene.mesh.size();
  for (const Assembly* assembly : {&design.warp_assembly, &design.weft_assembly})
    for (const ThreadSection& section : assembly->sections)
      sum += sizeof(ThreadSection) + bytes(section.rows) + bytes(section.threads);
  for (const YarnPurchase& bought : design.plan.purchases) sum += sizeof(YarnPurchase) + bought.yarn.size();
  for (const std::string& note : design.notes) sum += sizeof(std::string) + note.size();
  for (const Version& version : design.versions) sum += sizeof(Version) + version.name.size();
  return sum;
}

/// Of the versions that `from` does not share.
size_t version_bytes(const Design& from, const Design& to) {
  size_t sum = 0;
  for (const Version& version : to.versions)
    if (std::ranges::find(from.versions, version.design, &Version::design) == from.versions.end())
      sum += bytes(*version.design);
  return sum;
}

template <class T>
auto raw(std::span<T> values) {
  if constexpr (std::is_const_v<T>) return std::as_bytes(values);
  else return std::as_writable_bytes(values);
}

/// The parts in which strokes change cells or single threads.
template <class D>
auto painted_parts(D& design) {
  auto& d = design.draft;
  const auto grid = [](auto& m) {
    using Word = std::remove_reference_t<decltype(m.row(0)[0])>;
    return raw(m.rows() == 0 ? std::span<Word>() : std::span(m.row(0).data(), bytes(m) / sizeof(uint64_t)));
  };
  const auto table = [](auto& values) { return raw(std::span(values)); };
  return std::array{grid(d.threading),  grid(d.tieup),       grid(d.treadling),          grid(d.liftplan),
                    table(d.warp.yarn), table(d.warp.color), table(d.warp.thickness_mm), table(d.warp.spacing_mm),
                    table(d.weft.yarn), table(d.weft.color), table(d.weft.thickness_mm), table(d.weft.spacing_mm)};
}

/// Bits of one part that differ between two designs, from the first byte that does to the last.
struct Flips {
  size_t part = 0, first = 0;
  std::vector<std::byte> bits;
};

void flip(Design& design, const std::vector<Flips>& flips) {
  const auto parts = painted_parts(design);
  for (const Flips& f : flips)
    for (size_t i = 0; i < f.bits.size(); ++i) parts[f.part][f.first + i] ^= f.bits[i];
}

/// The bits that tell `to` from `from`; empty if more differs than painted parts of the same sizes.
std::vector<Flips> flips_between(const Design& from, Design to) {
  const auto old = painted_parts(from);
  const auto now = painted_parts(to);
  std::vector<Flips> flips;
  for (size_t part = 0; part < old.size(); ++part) {
    const std::span<const std::byte> a = old[part], b = now[part];
    if (a.size() != b.size()) return {};
    if (a.empty() || std::memcmp(a.data(), b.data(), a.size()) == 0) continue;
    const size_t first = static_cast<size_t>(std::ranges::mismatch(a, b).in1 - a.begin());
    size_t last = a.size();
    while (a[last - 1] == b[last - 1]) --last;
    Flips f{part, first, std::vector<std::byte>(last - first)};
    for (size_t i = first; i < last; ++i) f.bits[i - first] = a[i] ^ b[i];
    flips.push_back(std::move(f));
  }
  flip(to, flips);
  return to == from ? flips : std::vector<Flips>();
}

/// The design where the weaver is at the place of `loom`.
std::shared_ptr<const Design> at_place_of(const Loom& loom, std::shared_ptr<const Design> design) {
  Loom there = with_place_of(loom, design->loom);
  if (there == design->loom) return design;
  auto out = std::make_shared<Design>(*design);
  out->loom = there;
  return out;
}

}  // namespace

/// Between a step and the one before: the bits that it flips, or both designs.
struct History::Change {
  std::vector<Flips> flips;
  std::shared_ptr<const Design> before, after;
};

History::History(Design first) : now_(std::make_shared<const Design>(std::move(first))) {
  steps_.push_back({nullptr, {}, 0, 0, bytes(*now_) + version_bytes({}, *now_)});
  total_bytes_ = steps_.front().bytes;
  mark_saved();
}

/// The design of a step, at the present place at the loom.
std::shared_ptr<const Design> History::at(size_t step) const {
  std::shared_ptr<const Design> whole = now_;
  std::shared_ptr<Design> own;  // a copy of it in which bits were flipped
  const auto pass = [&](const Change& change, bool back) {
    if (change.before) {
      whole = back ? change.before : change.after;
      own.reset();
      return;
    }
    if (!own) own = std::make_shared<Design>(*whole);
    flip(*own, change.flips);
  };
  for (size_t k = position_; k > step; --k) pass(*steps_[k].change, true);
  for (size_t k = position_; k < step; ++k) pass(*steps_[k + 1].change, false);
  return at_place_of(now().loom, own ? own : whole);
}

/// A step after step `before`, whose design is `from`.
History::Step History::step_to(size_t before, const std::shared_ptr<const Design>& from,
                               const std::shared_ptr<const Design>& to) const {
  auto change = std::make_shared<Change>();
  Step step;
  step.bytes = sizeof(Step) + sizeof(Change);
  change->flips = flips_between(*from, *to);
  for (const Flips& f : change->flips) step.bytes += sizeof(Flips) + f.bits.capacity();
  if (change->flips.empty()) {
    change->before = from, change->after = to;
    const Change* last = steps_[before].change.get();
    step.bytes += bytes(*to) + version_bytes(*from, *to) + (last && last->after == from ? 0 : bytes(*from));
  }
  step.change = std::move(change);
  return step;
}

void History::commit(Design next, std::string label, uint64_t stroke) {
  const Loom moved = next.loom;
  next.loom = with_place_of(now().loom, next.loom);
  if (next == now()) {
    now_ = at_place_of(moved, now_);
    return;
  }
  const bool joins = stroke != 0 && position_ > 0 && steps_[position_].stroke == stroke;
  const size_t before = joins ? position_ - 1 : position_;
  const std::shared_ptr<const Design> from = at(before);
  if (joins && next == *from) {  // the stroke reverted itself
    drop_after(before);
    now_ = from, position_ = before;
    return;
  }
  auto to = std::make_shared<const Design>(std::move(next));
  Step step = step_to(before, from, to);
  step.label = std::move(label);
  step.stroke = stroke, step.id = next_id_;
  step.bytes += step.label.capacity();
  if (steps_.size() == steps_.capacity()) steps_.reserve(2 * steps_.size());  // nothing fails from here on
  drop_after(before);
  total_bytes_ += step.bytes;
  steps_.push_back(std::move(step));
  ++next_id_;
  now_ = std::move(to), position_ = before + 1;
  drop_oldest();
}

void History::drop_after(size_t step) {
  while (steps_.size() > step + 1) {
    total_bytes_ -= steps_.back().bytes;
    steps_.pop_back();
  }
}

void History::drop_oldest() {
  if (total_bytes_ <= kMaxHistoryBytes) return;
  const size_t enough = kMaxHistoryBytes - kMaxHistoryBytes / 64;  // a few at once, since all that stay are moved
  size_t dropped = 0;
  while (total_bytes_ > enough && steps_.size() - dropped > 2) total_bytes_ -= steps_[dropped++].bytes;
  if (dropped == 0) return;
  steps_.erase(steps_.begin(), steps_.begin() + static_cast<std::ptrdiff_t>(dropped));
  position_ -= dropped;
  // The first needs no difference from the one before it.
  Step& first = steps_.front();
  total_bytes_ -= first.bytes;
  first.change.reset(), first.label.clear();
  total_bytes_ += first.bytes = bytes(*now_) + version_bytes({}, *now_);
}

void History::undo() {
  if (can_undo()) go_to(position_ - 1);
}

void History::redo() {
  if (can_redo()) go_to(position_ + 1);
}

void History::go_to(size_t step) {
  now_ = at(std::min(step, steps_.size() - 1));
  position_ = std::min(step, steps_.size() - 1);
}

std::string History::undo_label() const { return can_undo() ? steps_[position_].label : std::string(); }

std::string History::redo_label() const { return can_redo() ? steps_[position_ + 1].label : std::string(); }

History::Mark History::mark() const { return {steps_[position_].id, with_place_of(now().loom, {})}; }

void History::mark_unsaved() { saved_.step = std::numeric_limits<uint64_t>::max(); }

bool History::is_saved(size_t step) const { return saved_ == Mark{steps_[step].id, with_place_of(now().loom, {})}; }

bool History::is_saved() const { return is_saved(position_); }

}  // namespace weftlight::design
