// From a picture to a drawdown: colours reduced, a weave for each, floats bounded.
//
// Colours are grouped by k-means over a histogram of 32 steps a channel, begun at even shares of the pixels in order
// of lightness, so that the same picture always gives the same colours (S. Lloyd, Least squares quantization in PCM,
// 1982). Regions are filled with shaded satins: the same bindings, with more or fewer ends up beside them.

#include <algorithm>
#include <array>
#include <cstdlib>
#include <numeric>

#include "draft/generators/families.h"

namespace weftlight::draft {
namespace {

constexpr int kSteps = 32;  // of a channel

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

std::vector<Center> settled(const std::vector<Bin>& bins, std::vector<Center> centers) {
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

// Length of the run that a cell is in, along a row or a column (cyclic), counting at most `most`.
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

// What changing a crossing costs: how far the floats that it would lie in pass the limit.
int cost_of_change(BitMatrix& m, int row, int col, int longest) {
  m.set(row, col, !m.get(row, col));
  const int cost = std::max(0, run_through(m, row, col, true, longest * 2) - longest) +
                   std::max(0, run_through(m, row, col, false, longest * 2) - longest);
  m.set(row, col, !m.get(row, col));
  return cost;
}

// One pass over the lines of one direction; true when something was changed.
bool bind_floats(BitMatrix& m, int longest, bool along_row) {
  bool changed = false;
  const int lines = along_row ? m.rows() : m.cols(), n = along_row ? m.cols() : m.rows();
  for (int line = 0; line < lines; ++line) {
    int run = 1;
    // A turn and a little more, so that a float over the edge is met whole.
    for (int i = 1; i < n + longest + 1; ++i) {
      const auto cell = [&](int k) { return along_row ? std::pair{line, k % n} : std::pair{k % n, line}; };
      const auto [row, col] = cell(i);
      const auto [row0, col0] = cell(i - 1);
      run = m.get(row, col) == m.get(row0, col0) ? run + 1 : 1;
      if (run <= longest) continue;
      int best = i, least = 1 << 30;
      for (int k = i; k > i - longest && k > 0; --k) {
        const auto [r, c] = cell(k);
        const int cost = cost_of_change(m, r, c, longest) * 64 + std::abs(i - longest / 2 - k);
        if (cost < least) least = cost, best = k;
      }
      const auto [r, c] = cell(best);
      m.set(r, c, !m.get(r, c));
      changed = true;
      run = i - best;
      if (run == 0) run = 1;
    }
  }
  return changed;
}

}  // namespace

Reduced reduced_colors(const Pixels& picture, int colors) {
  Reduced out;
  if (picture.rgb.empty()) return out;
  const std::vector<Bin> bins = histogram(picture);
  std::vector<Center> centers = settled(bins, first_centers(bins, std::clamp(colors, 1, 16)));
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

BitMatrix with_bounded_floats(BitMatrix cells, int longest) {
  constexpr int kPasses = 12;
  const int most = std::max(longest, 1);
  for (int pass = 0; pass < kPasses; ++pass) {
    const bool rows = cells.cols() > most && bind_floats(cells, most, true);
    const bool columns = cells.rows() > most && bind_floats(cells, most, false);
    if (!rows && !columns) break;
  }
  return cells;
}

BitMatrix picture_weave(const Pixels& picture, const PictureWeave& how) {
  const Reduced reduced = reduced_colors(picture, how.colors);
  const int shafts = std::clamp(how.shafts, 2, 64), step = satin_step(shafts);
  const int kinds = static_cast<int>(reduced.palette.size());
  BitMatrix cells(picture.height, picture.width);
  for (int pick = 0; pick < picture.height; ++pick)
    for (int end = 0; end < picture.width; ++end) {
      const size_t at = static_cast<size_t>(pick) * static_cast<size_t>(picture.width) + static_cast<size_t>(end);
      const int kind = reduced.index[at];
      const int up = kinds < 2 ? shafts / 2 : 1 + (shafts - 2) * (kinds - 1 - kind) / (kinds - 1);
      const int place = (((end - pick * step) % shafts) + shafts) % shafts;
      if (place < up) cells.set(pick, end, true);
    }
  return with_bounded_floats(std::move(cells), how.longest_float);
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
  design.draft.drive = Drive::kLiftplan;
  design.loom.authority = Authority::kLiftplan;
  return with_sett(std::move(design));
}

}  // namespace weftlight::draft
