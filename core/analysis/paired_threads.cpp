#include "analysis/paired_threads.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace weftlight::analysis {

namespace {

constexpr int kMinThreads = 8;

double share(int64_t part, int64_t of) { return of > 0 ? static_cast<double>(part) / static_cast<double>(of) : 0.0; }

/// Mean difference between thread i and thread i + apart, for every other i from `first` on or for all.
double mean_difference(const BitMatrix& threads, int first, int step, int apart) {
  const int n = threads.rows();
  int64_t differ = 0, cells = 0;
  for (int i = first; i < n; i += step, cells += threads.cols())
    differ += draft::differences(threads.row(i), threads.row((i + apart) % n));
  return share(differ, cells);
}

/// Every other thread, and what goes beside each of them.
struct Partners {
  double change = 0;  // fraction of these threads whose next one crosses otherwise
  double kept = 0;    // fraction that have the partner that most threads alike have
  size_t kinds = 0;   // of these threads
  size_t beside = 0;  // kinds of such partners
  size_t joins = 0;   // pairs of kinds that follow each other: as many as kinds on a line
};

Partners partners_of(const std::vector<int>& kind, int first) {
  const size_t n = kind.size();
  std::map<int, std::map<int, int>> beside;
  std::set<std::pair<int, int>> joins;
  int64_t count = 0, changes = 0, kept = 0;
  for (size_t i = static_cast<size_t>(first); i < n; i += 2, ++count) {
    ++beside[kind[i]][kind[(i + 1) % n]];
    const int own = kind[i], next = kind[(i + 2) % n];
    if (own == next) continue;
    ++changes, joins.insert({std::min(own, next), std::max(own, next)});
  }
  std::set<int> partners;
  for (const auto& [own, others] : beside) {
    const auto usual = std::ranges::max_element(others, {}, [](const auto& of) { return of.second; });
    kept += usual->second, partners.insert(usual->first);
  }
  return {share(changes, count), share(kept, count), beside.size(), partners.size(), joins.size()};
}

double share_on_top(const BitMatrix& cells) {
  int64_t up = 0;
  for (int p = 0; p < cells.rows(); ++p)
    for (int e = 0; e < cells.cols(); ++e) up += cells.get(p, e) ? 1 : 0;
  return share(up, int64_t{cells.rows()} * cells.cols());
}

/// blocks: a few opposite pairs are enough; otherwise only a line counts, which changes often and has many places.
bool has_parallel_pairs(const BitMatrix& threads, bool blocks) {
  constexpr double kLikeTheNextButOne = 0.6, kApart = 0.25;  // of the difference of a pair; of all cells
  constexpr double kKept = 0.75, kChanges = 0.25, kOpposite = 0.8;
  constexpr size_t kPlaces = 4, kBlocks = 3;
  const int n = threads.rows();
  if (n < kMinThreads || n % 2 != 0) return false;
  const double next_but_one = mean_difference(threads, 0, 1, 2);
  const std::vector<int> kind = draft::first_equal_rows(threads);
  for (const int first : {0, 1}) {
    const double pair = mean_difference(threads, first, 2, 1);
    if (pair < kApart || next_but_one > kLikeTheNextButOne * pair) continue;
    const Partners partners = partners_of(kind, first);
    if (partners.kept < kKept || 2 * partners.beside < partners.kinds) continue;
    if (blocks && pair >= kOpposite && partners.kinds >= kBlocks) return true;
    if (partners.kinds >= kPlaces && partners.change >= kChanges && 2 * partners.joins <= 3 * partners.kinds)
      return true;
  }
  return false;
}

/// Of each thread, every other cell.
BitMatrix every_other_cell(const BitMatrix& threads, int first) {
  BitMatrix out(threads.rows(), (threads.cols() - first + 1) / 2);
  for (int t = 0; t < out.rows(); ++t)
    for (int c = 0; c < out.cols(); ++c)
      if (threads.get(t, 2 * c + first)) out.set(t, c, true);
  return out;
}

}  // namespace

bool is_parallel(const BitMatrix& threads) {
  if (has_parallel_pairs(threads, true)) return true;
  // Jin: what binds the threads is no part of the line.
  return is_compound(threads) && (has_parallel_pairs(every_other_cell(threads, 0), false) ||
                                  has_parallel_pairs(every_other_cell(threads, 1), false));
}

bool is_compound(const BitMatrix& threads) {
  constexpr double kAlmost = 0.95;
  constexpr int kMinPairs = 2;
  const int n = threads.rows(), across = threads.cols();
  if (n < 2 * kMinPairs || n % 2 != 0 || across < 2 * kMinPairs || across % 2 != 0) return false;
  for (const int first : {0, 1}) {
    int64_t differ[2] = {0, 0};
    for (int i = first; i < n; i += 2)
      for (int c = 0; c < across; ++c) differ[c % 2] += threads.get(i, c) != threads.get((i + 1) % n, c) ? 1 : 0;
    const int64_t each = int64_t{n / 2} * (across / 2);
    const double even = share(differ[0], each), odd = share(differ[1], each);
    if (std::min(even, odd) <= 1 - kAlmost && std::max(even, odd) >= kAlmost) return true;
  }
  return false;
}

bool is_deflected(const BitMatrix& cells) {
  constexpr double kPlain = 0.08, kSolid = 0.03;
  if (cells.rows() < kMinThreads || cells.cols() < kMinThreads || share_of_plain(cells) < kPlain) return false;
  const SolidShare solid = share_of_solid(cells);
  return std::min(solid.up, solid.down) >= kSolid;
}

bool is_stitched(const BitMatrix& cells) {
  constexpr double kAlmostAll = 0.85, kBound = 0.1;
  if (cells.rows() < kMinThreads || cells.cols() < kMinThreads || cells.rows() % 2 != 0 || cells.cols() % 2 != 0)
    return false;
  const auto is_woven = [](double on_top) { return on_top >= kBound && on_top <= 1 - kBound; };
  for (const int shifted : {0, 1}) {
    const double first = share_on_top(every_other(cells, 0, shifted)),
                 second = share_on_top(every_other(cells, 1, 1 - shifted)),
                 between = share_on_top(every_other(cells, 0, 1 - shifted)),
                 across = share_on_top(every_other(cells, 1, shifted));
    if (is_woven(first) && is_woven(second) && std::max(between, across) >= kAlmostAll &&
        std::min(between, across) <= 1 - kAlmostAll)
      return true;
  }
  return false;
}

BitMatrix every_other(const BitMatrix& cells, int first_pick, int first_end) {
  BitMatrix out((cells.rows() - first_pick + 1) / 2, (cells.cols() - first_end + 1) / 2);
  for (int p = 0; p < out.rows(); ++p)
    for (int e = 0; e < out.cols(); ++e)
      if (cells.get(2 * p + first_pick, 2 * e + first_end)) out.set(p, e, true);
  return out;
}

SolidShare share_of_solid(const BitMatrix& cells) {
  const int picks = cells.rows(), ends = cells.cols();
  int64_t up = 0, down = 0;
  for (int p = 0; p < picks; ++p)
    for (int e = 0; e < ends; ++e) {
      int on = 0;
      for (int i = 0; i < 9; ++i)
        on += cells.get((p + picks + i / 3 - 1) % picks, (e + ends + i % 3 - 1) % ends) ? 1 : 0;
      up += on == 9 ? 1 : 0, down += on == 0 ? 1 : 0;
    }
  return {share(up, int64_t{picks} * ends), share(down, int64_t{picks} * ends)};
}

double share_of_plain(const BitMatrix& cells) {
  const int picks = cells.rows(), ends = cells.cols();
  int64_t plain = 0;
  for (int p = 0; p < picks; ++p)
    for (int e = 0; e < ends; ++e) {
      const bool up = cells.get(p, e);
      plain += cells.get((p + 1) % picks, e) != up && cells.get((p + picks - 1) % picks, e) != up &&
               cells.get(p, (e + 1) % ends) != up && cells.get(p, (e + ends - 1) % ends) != up;
    }
  return share(plain, int64_t{picks} * ends);
}

}  // namespace weftlight::analysis
