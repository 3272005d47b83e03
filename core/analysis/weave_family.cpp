// Sorts weaves into families, by descriptions that weavers use; the first that fits counts.
//
// Threads of one system that cross alike are one class. Where the classes of ends and picks form one circle, in which
// each crosses like its neighbour shifted by one place, the weave is a twill or a satin of as many threads; which, is
// said by the steps that neighbouring threads take along the circle. Lace, damask and pattern wefts have no such circle
// and are known by their parts: cells of plain weave, regular windows, or every other pick plain.

#include "analysis/weave_family.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstdlib>
#include <map>
#include <numeric>
#include <vector>

#include "analysis/floats.h"
#include "analysis/paired_threads.h"
#include "analysis/weave_layers.h"
#include "design/repeat.h"

namespace weftlight::analysis {

using design::Repeat, design::structure_repeat;
using draft::transposed;

namespace {

constexpr int kMaxThreads = 512;    // of each system that are looked at
constexpr int kLargestCircle = 64;  // classes of a twill or satin
constexpr double kMostly = 0.7;     // of the steps of a twill

BitMatrix cropped(const BitMatrix& cells, int picks, int ends) {
  BitMatrix out(picks, ends);
  for (int p = 0; p < picks; ++p)
    for (int e = 0; e < ends; ++e)
      if (cells.get(p, e)) out.set(p, e, true);
  return out;
}

/// One repeat, or its first threads.
BitMatrix looked_at(const BitMatrix& cells) {
  const Repeat repeat = structure_repeat(cells);
  return cropped(cells, std::min(repeat.picks, kMaxThreads), std::min(repeat.ends, kMaxThreads));
}

/// Threads of one system by class, counted in the order in which the classes first occur.
struct Classes {
  std::vector<int> of;     // the class of each thread
  std::vector<int> first;  // the first thread of each class
  int count() const { return static_cast<int>(first.size()); }
};

Classes classes_of(const BitMatrix& threads) {
  const std::vector<int> equal = draft::first_equal_rows(threads);
  Classes out;
  std::map<int, int> number;
  for (int i = 0; i < threads.rows(); ++i) {
    const auto [at, is_new] = number.try_emplace(equal[static_cast<size_t>(i)], out.count());
    if (is_new) out.first.push_back(i);
    out.of.push_back(at->second);
  }
  return out;
}

/// Both systems of a drawdown: its picks as rows, its ends as rows, and their classes.
struct Weave {
  BitMatrix picks, ends;
  Classes pick, end;

  explicit Weave(BitMatrix cells)
      : picks(std::move(cells)), ends(transposed(picks)), pick(classes_of(picks)), end(classes_of(ends)) {}
};

/// The fraction of neighbours, round the repeat, for which `holds(a, b)`.
template <class Holds>
double share_of_neighbours(const std::vector<int>& of, Holds holds) {
  int count = 0;
  for (size_t i = 0; i < of.size(); ++i) count += holds(of[i], of[(i + 1) % of.size()]) ? 1 : 0;
  return of.empty() ? 0 : static_cast<double>(count) / static_cast<double>(of.size());
}

double share_of_doubled(const Classes& c) {
  return share_of_neighbours(c.of, [](int a, int b) { return a == b; });
}

// ------------------------------------------------------------------------------------------------ plain and basket

WeaveFamily of_two_classes(const Weave& w) {
  const auto cell = [&](int p, int e) {
    return w.picks.get(w.pick.first[static_cast<size_t>(p)], w.end.first[static_cast<size_t>(e)]);
  };
  if (cell(0, 0) != cell(1, 1) || cell(0, 1) != cell(1, 0) || cell(0, 0) == cell(0, 1)) return WeaveFamily::kOther;
  return share_of_doubled(w.end) == 0 && share_of_doubled(w.pick) == 0 ? WeaveFamily::kPlain : WeaveFamily::kBasket;
}

// ------------------------------------------------------------------------------------------------ twill and satin

/// The classes of one system along a circle on which each crosses like the one before, a place on in the classes of
/// the other system.
struct Circle {
  std::vector<int> place;  // of each class
  int risers = 0;          // crossings at which a class is on top
};

/// Empty if there is no such circle through all classes.
Circle circle_of(const BitMatrix& threads, const Classes& own, const Classes& other) {
  const int n = own.count();
  if (n < 3 || n != other.count() || n > kLargestCircle) return {};
  std::map<uint64_t, int> class_of;  // by what it crosses, a bit for each class of the other system
  std::vector<uint64_t> crossed;
  for (int c = 0; c < n; ++c) {
    uint64_t bits = 0;
    for (int o = 0; o < n; ++o)
      bits |= uint64_t{threads.get(own.first[static_cast<size_t>(c)], other.first[static_cast<size_t>(o)])} << o;
    class_of[bits] = c;
    crossed.push_back(bits);
  }
  const uint64_t all = n == 64 ? ~uint64_t{0} : (uint64_t{1} << n) - 1;
  Circle circle{std::vector<int>(static_cast<size_t>(n), -1), std::popcount(crossed[0])};
  uint64_t bits = crossed[0];
  for (int place = 0; place < n; ++place) {
    const auto found = class_of.find(bits);
    if (found == class_of.end() || circle.place[static_cast<size_t>(found->second)] >= 0) return {};
    circle.place[static_cast<size_t>(found->second)] = place;
    bits = ((bits << 1) | (bits >> (n - 1))) & all;
  }
  return circle;
}

/// How neighbouring threads go along a circle of n places.
struct Steps {
  double by_one = 0;  // fraction of the steps that are one place, forth or back
  double turns = 0;   // fraction of the steps by one that turn back
  int constant = 0;   // 2 to n / 2 if all steps are that far one way; otherwise 0
};

Steps steps_of(const Classes& c, const std::vector<int>& place) {
  const int n = c.count();
  std::vector<int> steps;
  for (size_t i = 0; i < c.of.size(); ++i) {
    const int from = place[static_cast<size_t>(c.of[i])], to = place[static_cast<size_t>(c.of[(i + 1) % c.of.size()])];
    if (from != to) steps.push_back((to - from + n) % n);
  }
  if (steps.empty()) return {};
  Steps out;
  int ones = 0, turns = 0;
  for (size_t i = 0; i < steps.size(); ++i) {
    const int next = steps[(i + 1) % steps.size()];
    const bool one = steps[i] == 1 || steps[i] == n - 1;
    ones += one ? 1 : 0;
    turns += one && next == n - steps[i] && n > 2 ? 1 : 0;
  }
  out.by_one = static_cast<double>(ones) / static_cast<double>(steps.size());
  out.turns = ones == 0 ? 0 : static_cast<double>(turns) / ones;
  const int least = std::min(steps[0], n - steps[0]);
  if (least >= 2 && std::ranges::all_of(steps, [&](int s) { return s == steps[0]; })) out.constant = least;
  return out;
}

std::vector<int> in_order(int n) {
  std::vector<int> place(static_cast<size_t>(n));
  std::iota(place.begin(), place.end(), 0);
  return place;
}

/// Blocks of a 2/2 twill, threaded to and fro and treadled many times each: overshot without its tabby.
bool is_overshot_alone(const Weave& w, const Circle& circle, const Steps& along_ends) {
  constexpr double kRepeated = 0.3, kFewDoubled = 0.12, kManyTurns = 0.4;
  return w.end.count() == 4 && circle.risers == 2 && share_of_doubled(w.pick) >= kRepeated &&
         share_of_doubled(w.end) <= kFewDoubled && along_ends.turns >= kManyTurns;
}

WeaveFamily of_circle(const Weave& w) {
  const int n = w.end.count();
  // One of the systems is in the order in which its classes first occur, the other along the circle.
  const Circle of_ends = circle_of(w.ends, w.end, w.pick), of_picks = circle_of(w.picks, w.pick, w.end);
  if (of_ends.place.empty() && of_picks.place.empty()) return WeaveFamily::kOther;
  const bool by_ends = !of_ends.place.empty();
  const Circle& circle = by_ends ? of_ends : of_picks;
  const Steps ends = steps_of(w.end, by_ends ? circle.place : in_order(n)),
              picks = steps_of(w.pick, by_ends ? in_order(n) : circle.place);
  if (is_overshot_alone(w, circle, ends)) return WeaveFamily::kPattern;
  if (n == 3) return WeaveFamily::kTwill;
  const bool single = circle.risers == 1 || circle.risers == n - 1;
  // Of four threads only a broken twill has no two crossings that touch.
  if (n >= 5 && single && (by_ends ? ends : picks).constant >= 2) return WeaveFamily::kSatin;
  if (ends.by_one >= kMostly && picks.by_one >= kMostly) return WeaveFamily::kTwill;
  // Corkscrew: half of an odd number and a half rise, each two places from the one before the last.
  if (std::abs(2 * circle.risers - n) == 1 && ends.constant + picks.constant >= 2) return WeaveFamily::kTwill;
  if (is_parallel(w.ends) || is_parallel(w.picks)) return WeaveFamily::kParallel;
  return n == 4 && single ? WeaveFamily::kTwill : WeaveFamily::kOther;
}

// ------------------------------------------------------------------------------------------------ parts

/// Neighbours along a thread that cross otherwise, as in plain weave.
double alternation(const BitMatrix& threads, int thread) {
  int changes = 0;
  const int n = threads.cols();
  for (int i = 0; i < n; ++i) changes += threads.get(thread, i) != threads.get(thread, (i + 1) % n) ? 1 : 0;
  return static_cast<double>(changes) / n;
}

/// Every other thread is a tabby, opposite to the one before, and the others float over it.
bool has_tabby_between(const BitMatrix& threads) {
  constexpr double kPlain = 0.9;
  constexpr int kMinThreads = 8, kLongFloat = 3;
  const int n = threads.rows(), across = threads.cols();
  if (n < kMinThreads || n % 2 != 0 || across < 4) return false;
  for (int odd = 0; odd < 2; ++odd) {
    int opposite = 0, plain = 0;
    for (int i = odd; i < n; i += 2) {
      const int differ = draft::differences(threads.row(i), threads.row((i + 2) % n));
      opposite += differ >= kPlain * across ? 1 : 0;
      plain += alternation(threads, i) >= kPlain ? 1 : 0;
    }
    if (std::min(opposite, plain) < kPlain * (n / 2.0)) continue;
    BitMatrix pattern(n / 2, across);
    for (int i = 0; i < n / 2; ++i) std::ranges::copy(threads.row(2 * i + 1 - odd), pattern.row(i).begin());
    const LongestFloats floats = longest_floats(pattern);
    if (std::max(floats.weft_front, floats.weft_back) >= kLongFloat) return true;
  }
  return false;
}

/// Windows of n x n threads in which each end and each pick is on top k times; `by_count[k]`: their fraction.
std::vector<double> regular_windows(const BitMatrix& cells, int n) {
  constexpr int kStride = 3;  // sees every place of a block of 4, 5 or 8 in turn
  std::vector<double> by_count(static_cast<size_t>(n) + 1, 0.0);
  const int picks = cells.rows(), ends = cells.cols();
  int64_t all = 0;
  for (int p = 0; p < picks; p += kStride)
    for (int e = 0; e < ends; e += kStride) {
      std::vector<int> along(static_cast<size_t>(n), 0), down(static_cast<size_t>(n), 0);
      for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
          const int on = cells.get((p + i) % picks, (e + j) % ends) ? 1 : 0;
          along[static_cast<size_t>(i)] += on, down[static_cast<size_t>(j)] += on;
        }
      ++all;
      const auto same = [&](int count) { return count == along[0]; };
      if (std::ranges::all_of(along, same) && std::ranges::all_of(down, same))
        by_count[static_cast<size_t>(along[0])] += 1;
    }
  for (double& share : by_count) share /= static_cast<double>(std::max<int64_t>(1, all));
  return by_count;
}

/// Areas of a weave and of its reverse, each wide enough to be seen as such.
bool has_reversed_blocks(const BitMatrix& cells) {
  constexpr double kRegular = 0.2, kEach = 0.05;  // the windows at the edges of blocks are not regular
  constexpr double kRegularOfThree = 0.35;        // so small ones may be regular by chance
  for (const int n : {3, 4, 5, 8}) {
    const std::vector<double> share = regular_windows(cells, n);
    const double least = n == 3 ? kRegularOfThree : kRegular;
    for (int k = 1; 2 * k < n; ++k) {
      const double a = share[static_cast<size_t>(k)], b = share[static_cast<size_t>(n - k)];
      if (a + b >= least && std::min(a, b) >= kEach) return true;
    }
  }
  return false;
}

/// The fraction of threads that weave plain from edge to edge.
double share_of_tabby(const BitMatrix& threads) {
  constexpr double kPlain = 0.9;
  int plain = 0;
  for (int i = 0; i < threads.rows(); ++i) plain += alternation(threads, i) >= kPlain ? 1 : 0;
  return static_cast<double>(plain) / std::max(1, threads.rows());
}

/// Plain weave whose other threads leave it for floats here and there.
bool is_lace(const Weave& w) {
  constexpr double kSomePlain = 0.2, kSomeTabby = 0.3;
  constexpr int kShortest = 3, kLongest = 15, kMinThreads = 5;
  if (w.picks.rows() < kMinThreads || w.ends.rows() < kMinThreads) return false;
  const LongestFloats f = longest_floats(w.picks);
  const int longest = std::max({f.warp_front, f.warp_back, f.weft_front, f.weft_back});
  return longest >= kShortest && longest <= kLongest && share_of_plain(w.picks) >= kSomePlain &&
         std::max(share_of_tabby(w.ends), share_of_tabby(w.picks)) >= kSomeTabby;
}

/// The longest float of each thread on the side where it shows `up`, round the repeat.
std::vector<int> longest_of_each(const BitMatrix& threads, bool up) {
  std::vector<int> out;
  const int n = threads.cols();
  for (int t = 0; t < threads.rows(); ++t) {
    int longest = 0, run = 0;
    for (int i = 0; i < 2 * n; ++i) {
      run = threads.get(t, i % n) == up ? run + 1 : 0;
      longest = std::max(longest, std::min(run, n));
    }
    out.push_back(longest);
  }
  return out;
}

/// From plain weave to long floats and back, a little with each thread.
bool grows_and_shrinks(const std::vector<int>& floats) {
  constexpr int kStep = 2, kLong = 3;
  constexpr double kSteps = 0.5;
  const auto [least, most] = std::ranges::minmax(floats);
  return most >= kLong && least == 1 &&
         share_of_neighbours(floats, [](int a, int b) { return std::abs(a - b) <= kStep; }) == 1 &&
         share_of_neighbours(floats, [](int a, int b) { return a != b; }) >= kSteps;
}

bool is_waffle(const Weave& w) {
  constexpr int kLong = 5;  // of either system
  const std::vector<int> warp = longest_of_each(w.ends, true), weft = longest_of_each(w.picks, false);
  return grows_and_shrinks(warp) && grows_and_shrinks(weft) &&
         std::max(std::ranges::max(warp), std::ranges::max(weft)) >= kLong;
}

/// Blocks of plain weave beside blocks of one system's floats alone.
bool is_honeycomb(const Weave& w) {
  constexpr double kPlain = 0.2, kSolid = 0.15;
  const SolidShare solid = share_of_solid(w.picks);
  return share_of_plain(w.picks) >= kPlain && solid.up + solid.down >= kSolid;
}

/// Two plain weaves that change places from block to block, and so hang together where blocks meet.
bool is_double_in_blocks(const BitMatrix& cells) {
  constexpr double kPlain = 0.7, kNotPlain = 0.2;
  constexpr int kMinThreads = 8;
  if (cells.rows() < kMinThreads || cells.cols() < kMinThreads) return false;
  for (int shifted = 0; shifted < 2; ++shifted)
    if (share_of_plain(every_other(cells, 0, shifted)) >= kPlain &&
        share_of_plain(every_other(cells, 1, 1 - shifted)) >= kPlain &&
        share_of_plain(every_other(cells, 0, 1 - shifted)) <= kNotPlain)
      return true;
  return false;
}

/// Two and more layers of ends and picks; or so many loose threads that there is no cloth.
enum class Held { kOnce, kInLayers, kNotAtAll };

Held held_together(const BitMatrix& cells) {
  constexpr double kManyLoose = 0.1;
  int cloths = 0;
  size_t loose = 0;
  for (const WeaveLayer& layer : weave_layers(cells)) {
    if (layer.loose()) loose += layer.ends.size() + layer.picks.size();
    else ++cloths;
  }
  if (static_cast<double>(loose) > kManyLoose * (cells.rows() + cells.cols()) || cloths == 0) return Held::kNotAtAll;
  return cloths > 1 ? Held::kInLayers : Held::kOnce;
}

}  // namespace

WeaveFamily weave_family(const BitMatrix& cells) {
  if (cells.rows() < 2 || cells.cols() < 2) return WeaveFamily::kOther;
  const Held held = held_together(cells);
  if (held != Held::kOnce) return held == Held::kInLayers ? WeaveFamily::kDouble : WeaveFamily::kOther;
  const Weave w(looked_at(cells));
  if (w.pick.count() < 2 || w.end.count() < 2) return WeaveFamily::kOther;
  if (w.pick.count() == 2 && w.end.count() == 2) return of_two_classes(w);
  if (const WeaveFamily family = of_circle(w); family != WeaveFamily::kOther) return family;
  if (is_double_in_blocks(w.picks) || is_stitched(w.picks) || is_deflected(w.picks)) return WeaveFamily::kDouble;
  if (is_parallel(w.ends) || is_parallel(w.picks)) return WeaveFamily::kParallel;
  if (has_tabby_between(w.picks) || has_tabby_between(w.ends) || is_compound(w.picks) || is_compound(w.ends))
    return WeaveFamily::kPattern;
  if (has_reversed_blocks(w.picks)) return WeaveFamily::kBlock;
  if (is_waffle(w) || is_honeycomb(w)) return WeaveFamily::kCells;
  return is_lace(w) ? WeaveFamily::kLace : WeaveFamily::kOther;
}

std::optional<WeaveFamily> family_of_id(std::string_view id) {
  for (size_t i = 0; i < kWeaveFamilies; ++i)
    if (id == kWeaveFamilyNames[i].id) return static_cast<WeaveFamily>(i);
  return {};
}

}  // namespace weftlight::analysis
