// From a picture to a drawdown: reduce the colours, fill each with a weave, limit the floats.
//
// Colours are clustered by k-means over a histogram of 32 steps per channel. The first centres are at equal fractions
// of the pixels by lightness, so that the result is deterministic (S. Lloyd, Least squares quantization in PCM, 1982).
// Regions are filled with shaded satins: the same binding points, with more or fewer ends up beside them.
//
// Long floats are bound one at a time, where that makes the fewest other floats too long, until none is left (after B.
// Selman, H. Kautz, B. Cohen, Noise strategies for improving local search, 1994).

#include <algorithm>
#include <array>
#include <cstdlib>
#include <deque>
#include <numeric>
#include <random>
#include <utility>

#include "base/text.h"
#include "weaves/families.h"

namespace weftlight::weaves {

using base::arg, base::fill, base::tr;
using design::Design, design::Leading;
using draft::BitMatrix, draft::Rgb, draft::ShedControl, draft::blank_draft, draft::drawdown, draft::kMaxCells,
    draft::kMaxShafts, draft::kMaxThreads;

namespace {

constexpr int kSteps = 32;            // per channel
constexpr int kMaxShadedShafts = 64;  // of a weave that stands for a colour
// One float in so many is bound at a random cell, so that two floats cannot undo each other for ever.
constexpr unsigned kRandomBinding = 16, kBindingSeed = 1;
constexpr int64_t kMaxBindingsPerCrossing = 8;  // then plain weave is used; pictures take less than one

struct Bin {
  std::array<double, 3> sum{};
  double count = 0;
  double channel(int c) const { return sum[static_cast<size_t>(c)] / count; }
  double lightness() const { return 0.2126 * channel(0) + 0.7152 * channel(1) + 0.0722 * channel(2); }
};

int step_of(float channel) { return std::clamp(static_cast<int>(channel * kSteps), 0, kSteps - 1); }

int bin_of(const Rgb& c) { return (step_of(c.r) * kSteps + step_of(c.g)) * kSteps + step_of(c.b); }

std::vector<Bin> histogram(const Pixels& picture) {
  std::vector<Bin> bins(kSteps * kSteps * kSteps);
  for (const Rgb& c : picture.rgb) {
    Bin& bin = bins[static_cast<size_t>(bin_of(c))];
    bin.sum[0] += static_cast<double>(c.r);
    bin.sum[1] += static_cast<double>(c.g);
    bin.sum[2] += static_cast<double>(c.b);
    ++bin.count;
  }
  return bins;
}

using Center = std::array<double, 3>;

int nearest(const std::vector<Center>& centers, const Bin& bin) {
  int best = 0;
  double least = 1e30;
  for (size_t i = 0; i < centers.size(); ++i) {
    double sum = 0;
    for (int c = 0; c < 3; ++c) {
      const double d = bin.channel(c) - centers[i][static_cast<size_t>(c)];
      sum += d * d;
    }
    if (sum >= least) continue;
    least = sum;
    best = static_cast<int>(i);
  }
  return best;
}

std::vector<Center> first_centers(const std::vector<Bin>& bins, int colors) {
  std::vector<const Bin*> used;
  double total = 0;
  for (const Bin& bin : bins)
    if (bin.count > 0) used.push_back(&bin), total += bin.count;
  std::ranges::stable_sort(used, [](const Bin* a, const Bin* b) { return a->lightness() < b->lightness(); });
  std::vector<Center> centers;
  double passed = 0;
  for (const Bin* bin : used) {
    passed += bin->count;
    if (static_cast<int>(centers.size()) < colors &&
        passed >= total * (static_cast<double>(centers.size()) + 0.5) / colors)
      centers.push_back({bin->channel(0), bin->channel(1), bin->channel(2)});
  }
  return centers;
}

std::vector<Center> refined_centers(const std::vector<Bin>& bins, std::vector<Center> centers) {
  constexpr int kRounds = 16;
  for (int round = 0; round < kRounds; ++round) {
    std::vector<Bin> sums(centers.size());
    for (const Bin& bin : bins) {
      if (bin.count <= 0) continue;
      Bin& sum = sums[static_cast<size_t>(nearest(centers, bin))];
      for (size_t c = 0; c < 3; ++c) sum.sum[c] += bin.sum[c];
      sum.count += bin.count;
    }
    std::vector<Center> next;
    for (const Bin& sum : sums)
      if (sum.count > 0) next.push_back({sum.channel(0), sum.channel(1), sum.channel(2)});
    if (next == centers) break;
    centers = std::move(next);
  }
  return centers;
}

double lightness(const Center& c) { return 0.2126 * c[0] + 0.7152 * c[1] + 0.0722 * c[2]; }

int satin_step(int shafts) {
  const std::vector<int> steps = satin_steps(shafts);
  return steps.empty() ? 1 : steps[steps.size() / 2];
}

// Length of the run of a cell along its row or column, cyclic, counted up to `most`.
int run_through(const BitMatrix& m, int row, int col, bool along_row, int most) {
  const bool value = m.get(row, col);
  const int n = along_row ? m.cols() : m.rows();
  const auto at = [&](int i) {
    const int k = ((i % n) + n) % n;
    return along_row ? m.get(row, k) : m.get(k, col);
  };
  const int here = along_row ? col : row;
  int run = 1;
  for (int i = 1; i < n && run <= most && at(here + i) == value; ++i) ++run;
  for (int i = 1; i < n && run <= most && at(here - i) == value; ++i) ++run;
  return run;
}

// Cost of changing a crossing: by how much its new floats exceed the limit.
int cost_of_change(BitMatrix& m, int row, int col, int longest) {
  m.set(row, col, !m.get(row, col));
  const int cost = std::max(0, run_through(m, row, col, true, longest * 2) - longest) +
                   std::max(0, run_through(m, row, col, false, longest * 2) - longest);
  m.set(row, col, !m.get(row, col));
  return cost;
}

// A row or a column; cell indices are cyclic.
struct RowOrColumn {
  bool along_row = false;
  int number = 0;
  int size(const BitMatrix& m) const { return along_row ? m.cols() : m.rows(); }
  std::pair<int, int> cell(const BitMatrix& m, int i) const {
    return along_row ? std::pair{number, i % m.cols()} : std::pair{i % m.rows(), number};
  }
  bool at(const BitMatrix& m, int i) const {
    const auto [row, col] = cell(m, i);
    return m.get(row, col);
  }
};

// The best cell to bind a run of `length` cells: where the fewest other floats exceed the limit, then closest to an
// even division of the run.
int best_binding(BitMatrix& m, const RowOrColumn& line, int first, int length, int most) {
  const int bindings = length / (most + 1), even = (length - bindings) / (bindings + 1);
  int best = 0, least = 1 << 30;
  for (int k = 0; k <= most && k < length; ++k) {
    const auto [row, col] = line.cell(m, first + k);
    const int cost = cost_of_change(m, row, col, most) * 64 + std::abs(even - k);
    if (cost < least) least = cost, best = k;
  }
  return best;
}

// Binds each run of the line that is longer than `most`; calls changed(cell) for each changed cell.
template <typename Changed>
void bind_line(BitMatrix& m, const RowOrColumn& line, int most, std::mt19937& chance, const Changed& changed) {
  const int n = line.size(m);
  int start = 0;
  while (start < n && line.at(m, start) == line.at(m, start + n - 1)) ++start;
  start %= n;
  for (int first = start; first < start + n;) {
    int end = first + 1;
    while (end < start + n && line.at(m, end) == line.at(m, first)) ++end;
    if (end - first <= most) {
      first = end;
      continue;
    }
    const int at = chance() % kRandomBinding == 0 ? static_cast<int>(chance() % static_cast<unsigned>(end - first))
                                                  : best_binding(m, line, first, end - first, most);
    const auto [row, col] = line.cell(m, first + at);
    m.set(row, col, !m.get(row, col));
    changed((first + at) % n);
    first += at + 1;
  }
}

BitMatrix plain(int rows, int cols) {
  BitMatrix m(rows, cols);
  for (int row = 0; row < rows; ++row)
    for (int col = row % 2; col < cols; col += 2) m.set(row, col, true);
  return m;
}

}  // namespace

Reduced reduced_colors(const Pixels& picture, int colors) {
  Reduced out;
  if (picture.rgb.empty()) return out;
  const std::vector<Bin> bins = histogram(picture);
  std::vector<Center> centers = refined_centers(bins, first_centers(bins, std::clamp(colors, 1, 16)));
  std::ranges::stable_sort(centers, [](const Center& a, const Center& b) { return lightness(a) < lightness(b); });
  for (const Center& c : centers)
    out.palette.push_back({static_cast<float>(c[0]), static_cast<float>(c[1]), static_cast<float>(c[2])});
  std::vector<int> of_bin(bins.size(), -1);
  out.index.reserve(picture.rgb.size());
  for (const Rgb& c : picture.rgb) {
    const auto bin = static_cast<size_t>(bin_of(c));
    if (of_bin[bin] < 0) of_bin[bin] = nearest(centers, bins[bin]);
    out.index.push_back(of_bin[bin]);
  }
  return out;
}

BitMatrix with_bounded_floats(BitMatrix cells, int longest, const base::TaskProgress& progress) {
  const int most = std::max(longest, 1), rows = cells.rows(), cols = cells.cols();
  if (most == 1) return plain(rows, cols);
  // Lines to check: row r as r, column c as rows + c.
  std::deque<int> lines;
  std::vector<char> queued(static_cast<size_t>(rows + cols), 0);
  const auto check = [&](int line) {
    if ((line < rows ? cols : rows) > most && !std::exchange(queued[static_cast<size_t>(line)], 1))
      lines.push_back(line);
  };
  for (int line = 0; line < rows + cols; ++line) check(line);
  std::mt19937 chance(kBindingSeed);
  int64_t left = kMaxBindingsPerCrossing * rows * cols;
  while (!lines.empty() && left > 0 && !progress.stopped()) {
    const int line = lines.front();
    lines.pop_front();
    queued[static_cast<size_t>(line)] = 0;
    const bool along_row = line < rows;
    bind_line(cells, {along_row, along_row ? line : line - rows}, most, chance, [&](int at) {
      --left;
      check(line);
      check(along_row ? rows + at : at);
    });
  }
  return left > 0 ? cells : plain(rows, cols);
}

BitMatrix shaded_satin(int shafts, int up) {
  const int n = std::clamp(shafts, 2, kMaxShadedShafts), step = satin_step(n);
  BitMatrix repeat(n, n);
  for (int pick = 0; pick < n; ++pick)
    for (int end = 0; end < n; ++end)
      if ((((end - pick * step) % n) + n) % n < up) repeat.set(pick, end, true);
  return repeat;
}

BitMatrix picture_weave(const Pixels& picture, const Reduced& reduced, const PictureWeave& how,
                        const base::TaskProgress& progress) {
  const int shafts = std::clamp(how.shafts, 2, kMaxShadedShafts);
  const int colors = static_cast<int>(reduced.palette.size());
  std::vector<BitMatrix> weaves(how.weaves.begin(),
                                how.weaves.begin() + std::min(colors, static_cast<int>(how.weaves.size())));
  weaves.resize(static_cast<size_t>(colors));
  for (int color = 0; color < colors; ++color) {
    BitMatrix& weave = weaves[static_cast<size_t>(color)];
    const int up = colors < 2 ? shafts / 2 : 1 + (shafts - 2) * (colors - 1 - color) / (colors - 1);
    if (weave.rows() < 1 || weave.cols() < 1) weave = shaded_satin(shafts, up);
  }
  BitMatrix cells(picture.height, picture.width);
  size_t at = 0;
  for (int pick = 0; pick < picture.height; ++pick)
    for (int end = 0; end < picture.width; ++end) {
      const BitMatrix& weave = weaves[static_cast<size_t>(reduced.index[at++])];
      if (weave.get(pick % weave.rows(), end % weave.cols())) cells.set(pick, end, true);
    }
  return with_bounded_floats(std::move(cells), how.longest_float, progress);
}

BitMatrix picture_weave(const Pixels& picture, const PictureWeave& how) {
  return picture_weave(picture, reduced_colors(picture, how.colors), how);
}

base::Result<BitMatrix> read_weave_words(std::string_view words) {
  const auto word = [&words](std::string_view name) {
    if (!words.starts_with(name)) return false;
    words.remove_prefix(name.size());
    while (words.starts_with(' ')) words.remove_prefix(1);
    return true;
  };
  const std::string all(words);
  const auto none = [&all] {
    return base::failure(base::ErrorKind::kUsage,
                         fill(tr("'{words}' is not a weave; write plain, twill 2/1, twill 1/3 left, satin 8/3 (3 of 8 "
                                 "ends up), an ISO 9354 code, or the path of a draft"),
                              arg("words", all)));
  };
  if (words.empty() || words == "auto") return BitMatrix();
  if (words == "plain") return plain(2, 2);
  if (word("twill")) {
    const bool left = words.ends_with("left");
    if (left) words.remove_suffix(4);
    const OverUnder order = read_ratio(words);
    const int repeat = std::accumulate(order.begin(), order.end(), 0);
    if (order.empty() || repeat > kMaxShadedShafts) return none();
    return drawdown(twill(order, left ? Lean::kLeft : Lean::kRight, {repeat, repeat}).draft);
  }
  if (word("satin")) {
    const OverUnder order = read_ratio(words);
    if (order.size() != 2 || order[0] < 5 || order[0] > kMaxShadedShafts || order[1] >= order[0] ||
        satin_steps(order[0]).empty())
      return none();
    return shaded_satin(order[0], order[1]);
  }
  base::Result<BitMatrix> code = read_iso_code(words);
  if (code) return code;
  return none();
}

std::optional<Design> jacquard_design(const BitMatrix& cells) {
  const int64_t crossings = int64_t{cells.rows()} * cells.cols();
  if (cells.rows() < 1 || cells.cols() < 1 || cells.rows() > kMaxThreads || cells.cols() > kMaxShafts ||
      crossings > kMaxCells)
    return {};
  Design design;
  design.draft = blank_draft(cells.cols(), cells.rows(), cells.cols(), 1);
  for (int e = 0; e < cells.cols(); ++e) design.draft.threading.set(e, e, true);
  design.draft.liftplan = cells;
  design.draft.shed_control = ShedControl::kLiftplan;
  design.loom.leading = Leading::kLiftplan;
  return with_sett(std::move(design));
}

}  // namespace weftlight::weaves
