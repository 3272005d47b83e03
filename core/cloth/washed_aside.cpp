#include "cloth/washed_aside.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>

#include "base/loops.h"
#include "cloth/bake_parts.h"
#include "cloth/thickness.h"

namespace weftlight::cloth {

using base::for_each_job;
using draft::BitMatrix;

namespace {

// How often two neighbours are held apart is counted over some crossings on each side. The ones at the ends count half,
// so that whatever repeats every 2 or 4 threads, and with the longer count every 8, counts alike everywhere. The longer
// one finds groups all along a cloth, as those of a huck lace, the shorter one floats between squares of plain weave.
struct Count {
  int reach;
  // From this difference between gaps on one gives room to the other, and from `whole` on all that it can; by eye.
  float least, whole;
  int sum() const { return 4 * reach; }
};
constexpr std::array kCounts{Count{4, 0.12f, 0.5f}, Count{2, 0.5f, 0.9f}};
// A gap is compared with those around it: it gives room if it is held apart less often than their mean.
constexpr int kAround = 5, kAroundSum = 4 * kAround;
// A gap gives its room to those up to so many threads away, and keeps a little.
constexpr int kGiven = 4;
constexpr float kMaxGiven = 0.9f;
static_assert(2 * kGiven + kAround + 1 == kAsideReach);
constexpr float kTouching = 1.06f;   // spacing over width of threads that touch (lay_out.cpp)
constexpr float kMaxOfRoom = 0.95f;  // of half a thread's room: shaders look no further for a thread
constexpr float kMinMove = 0.06f;    // of the mean spacing: less is hardly seen, and straight threads are drawn faster

// A thread bends over so many crossings on each side.
constexpr int kSmooth = 2;
static_assert(kCounts[0].reach + kSmooth <= kAsideReach);

/// A row of gaps, each after the thread of its index; periodic.
template <class T>
class Row {
 public:
  explicit Row(size_t n) : values_(std::max<size_t>(n, 1)) {}
  T& operator[](int i) { return values_[static_cast<size_t>(wrap(i, static_cast<int>(values_.size())))]; }

  std::vector<T>& values() { return values_; }

 private:
  std::vector<T> values_;
};

/// For each crossing whether the thread of the other system passes between its thread and the next.
class HeldApart {
 public:
  explicit HeldApart(const BitMatrix& up)
      : rows_(up.rows()), cols_(up.cols()), held_(static_cast<size_t>(rows_) * static_cast<size_t>(cols_)) {
    for_each_job(rows_, [&](int r) {
      uint8_t* const out = &held_[static_cast<size_t>(r) * static_cast<size_t>(cols_)];
      for (int k = 0; k < cols_; ++k) out[k] = up.get(r, k) != up.get(r, k + 1 < cols_ ? k + 1 : 0) ? 1 : 0;
    });
  }
  /// Wraps.
  const uint8_t* row(int crossing) const {
    return &held_[static_cast<size_t>(wrap(crossing, rows_)) * static_cast<size_t>(cols_)];
  }

 private:
  int rows_, cols_;
  std::vector<uint8_t> held_;
};

/// Sum over `reach` on each side of i, those at the ends counted half; twice that.
template <class At>
int twice_sum(int i, int reach, const At& at) {
  int sum = at(i - reach) + at(i + reach);
  for (int k = 1 - reach; k < reach; ++k) sum += 2 * at(i + k);
  return sum;
}

/// Threads of one system, as the columns of `up`.
class Movement {
 public:
  Movement(std::span<const ThreadBody> threads, float washed) : limit_(furthest(threads)) {
    const size_t n = threads.size();
    for (size_t i = 0; i < n; ++i) {
      const ThreadBody &a = threads[i], &b = threads[i + 1 < n ? i + 1 : 0];
      const float open = 0.5f * (a.spacing_mm - kTouching * a.width_mm + b.spacing_mm - kTouching * b.width_mm);
      free_.push_back(kMaxGiven * washed * std::max(open, 0.0f));
    }
  }
  /// Whether there is any room to move in.
  bool possible() const {
    return limit_ > 0 && std::ranges::any_of(free_, [](float mm) { return mm > 0; });
  }
  /// Offsets of the threads in a row of crossings.
  std::vector<float> row(const HeldApart& apart, int crossing) const {
    const int n = static_cast<int>(free_.size());
    Row<float> gives(static_cast<size_t>(n)), takes(static_cast<size_t>(n));
    for (const Count& count : kCounts) compare(count, apart, crossing, gives, takes);
    std::vector<float> moved(static_cast<size_t>(n));
    for (int k = 0; k < n; ++k) give(k, gives[k] * free_[static_cast<size_t>(k)], takes, moved);
    for (float& mm : moved) mm = std::clamp(mm, -limit_, limit_);
    return moved;
  }

 private:
  static float furthest(std::span<const ThreadBody> threads) {
    float least = threads.empty() ? 0 : threads.front().spacing_mm;
    for (const ThreadBody& t : threads) {
      const float half_room = 0.5f * t.spacing_mm, uneven = furthest_side(t) - half_room;
      least = std::min(least, kMaxOfRoom * half_room - std::max(uneven, 0.0f));
    }
    return std::max(least, 0.0f);
  }
  /// How much of its room each gap in a row of crossings gives, and how much it wants; 0 to 1.
  void compare(const Count& count, const HeldApart& apart, int crossing, Row<float>& gives, Row<float>& takes) const {
    const int n = static_cast<int>(free_.size());
    Row<int> held(free_.size());
    for (int c = -count.reach; c <= count.reach; ++c) {
      const int weight = std::abs(c) == count.reach ? 1 : 2;
      const uint8_t* const row = apart.row(crossing + c);
      for (int k = 0; k < n; ++k) held.values()[static_cast<size_t>(k)] += weight * row[k];
    }
    for (int k = 0; k < n; ++k) {
      const bool more = kAroundSum * held[k] > twice_sum(k, kAround, [&](int at) { return held[at]; });
      int most = 0;
      for (int i = -kAround; i <= kAround; ++i) most = std::max(most, (held[k] - held[k + i]) * (more ? 1 : -1));
      const float part = static_cast<float>(most) / static_cast<float>(count.sum());
      float& to = more ? takes[k] : gives[k];
      to = std::max(to, std::clamp((part - count.least) / (count.whole - count.least), 0.0f, 1.0f));
    }
  }
  /// Hands the room of a gap to those that take some; the threads between them move.
  void give(int gap, float mm, Row<float>& takes, std::vector<float>& moved) const {
    if (mm <= 0) return;
    const auto wants = [&](int away) { return takes[gap + away] * static_cast<float>(kGiven + 1 - std::abs(away)); };
    float all = 0;
    for (int away = 1; away <= kGiven; ++away) all += wants(away) + wants(-away);
    if (all <= 0) return;
    const int n = static_cast<int>(free_.size());
    for (int away = 1; away <= kGiven; ++away) {
      const float after = mm * wants(away) / all, before = mm * wants(-away) / all;
      for (int i = 0; i < away; ++i) {
        moved[static_cast<size_t>(wrap(gap + 1 + i, n))] -= after;
        moved[static_cast<size_t>(wrap(gap - i, n))] += before;
      }
    }
  }

  std::vector<float> free_;  // by gap, what it can give
  float limit_;
};

/// crossings x threads; empty where none moves.
std::vector<float> moves(const BitMatrix& up, std::span<const ThreadBody> threads, float spacing, float washed) {
  const Movement movement(threads, washed);
  if (!movement.possible()) return {};
  const HeldApart apart(up);
  const size_t n = threads.size();
  std::vector<float> moved(static_cast<size_t>(up.rows()) * n), out(moved.size());
  for_each_job(up.rows(), [&](int c) {
    std::ranges::copy(movement.row(apart, c), moved.begin() + static_cast<std::ptrdiff_t>(static_cast<size_t>(c) * n));
  });
  for_each_job(up.rows(), [&](int c) {
    for (int k = -kSmooth; k <= kSmooth; ++k) {
      const float part = (std::abs(k) == kSmooth ? 1.0f : 2.0f) / (4 * kSmooth);
      const size_t from = static_cast<size_t>(wrap(c + k, up.rows())) * n, to = static_cast<size_t>(c) * n;
      for (size_t i = 0; i < n; ++i) out[to + i] += part * moved[from + i];
    }
  });
  if (std::ranges::none_of(out, [&](float mm) { return std::abs(mm) > kMinMove * spacing; })) return {};
  return out;
}

}  // namespace

WashedAside washed_aside(const Cloth& cloth, float washed) {
  const int ends = cloth.up.cols(), picks = cloth.up.rows();
  if (!(washed > 0) || !cloth.layers.empty() || ends == 0 || picks == 0 || int64_t{ends} * picks > kMaxAsideCrossings)
    return {};
  WashedAside out;
  out.warp_mm = moves(cloth.up, cloth.ends, cloth.width_mm / static_cast<float>(ends), std::min(washed, 1.0f));
  const std::vector<float> weft =
      moves(transposed(cloth.up), cloth.picks, cloth.depth_mm / static_cast<float>(picks), std::min(washed, 1.0f));
  if (out.warp_mm.empty() && weft.empty()) return {};
  const size_t all = static_cast<size_t>(ends) * static_cast<size_t>(picks);
  out.warp_mm.resize(all), out.weft_mm.resize(all);
  if (weft.empty()) return out;
  for (size_t p = 0, at = 0; p < static_cast<size_t>(picks); ++p)
    for (size_t e = 0; e < static_cast<size_t>(ends); ++e, ++at)
      out.weft_mm[at] = weft[e * static_cast<size_t>(picks) + p];
  return out;
}

float furthest_aside(const Cloth& cloth) {
  float most = 0;
  for (const std::vector<float>* of : {&cloth.warp_aside_mm, &cloth.weft_aside_mm})
    for (const float mm : *of) most = std::max(most, std::abs(mm));
  return most;
}

}  // namespace weftlight::cloth
