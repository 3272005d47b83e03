#include "cloth/texel_cover.h"

#include <algorithm>
#include <bit>
#include <cstdint>

namespace weftlight::cloth {
namespace {

struct Run {
  int from = 0, to = 0;
};

int next_bit(std::span<const uint64_t> words, int from, bool set) {
  const int bits = static_cast<int>(words.size()) * 64;
  for (int at = from; at < bits; at = (at | 63) + 1) {
    const uint64_t word = words[static_cast<size_t>(at >> 6)];
    const uint64_t rest = (set ? word : ~word) >> (at & 63);
    if (rest) return at + std::countr_zero(rest);
  }
  return bits;
}

/// Runs of set bits; runs closer than `gap` are merged.
void runs_of(std::span<const uint64_t> words, int gap, std::vector<Run>& runs) {
  runs.clear();
  const int bits = static_cast<int>(words.size()) * 64;
  for (int from = next_bit(words, 0, true); from < bits;) {
    const int to = next_bit(words, from, false);
    if (!runs.empty() && from - runs.back().to <= gap) runs.back().to = to;
    else runs.push_back({from, to});
    from = next_bit(words, to, true);
  }
}

/// Rows with one common set of runs.
struct Band {
  int y0 = 0, y1 = 0;
  std::vector<uint64_t> words;
  std::vector<Run> runs;
  int64_t cost = 0;

  void measure(int overhead) {
    const int rows = y1 - y0;
    runs_of(words, overhead / rows, runs);
    cost = 0;
    for (const Run& r : runs) cost += int64_t{r.to - r.from} * rows + overhead;
  }
};

Band joined(const Band& a, const Band& b, int overhead) {
  Band out{a.y0, b.y1, a.words, {}, 0};
  for (size_t i = 0; i < out.words.size(); ++i) out.words[i] |= b.words[i];
  out.measure(overhead);
  return out;
}

}  // namespace

void set_run(std::span<uint64_t> row, int from, int to) {
  if (from >= to) return;
  const size_t a = static_cast<size_t>(from >> 6), b = static_cast<size_t>((to - 1) >> 6);
  const uint64_t head = ~uint64_t{0} << (from & 63), tail = ~uint64_t{0} >> (63 - ((to - 1) & 63));
  if (a == b) {
    row[a] |= head & tail;
    return;
  }
  row[a] |= head;
  std::fill(row.begin() + static_cast<std::ptrdiff_t>(a) + 1, row.begin() + static_cast<std::ptrdiff_t>(b),
            ~uint64_t{0});
  row[b] |= tail;
}

std::vector<TexelRect> cover(const BitMatrix& mask, int overhead) {
  std::vector<TexelRect> out;
  Band band;
  const auto close = [&] {
    for (const Run& r : band.runs) out.push_back({r.from, band.y0, r.to, band.y1});
    band.runs.clear();
  };
  for (int y = 0; y < mask.rows(); ++y) {
    const auto words = mask.row(y);
    Band row{y, y + 1, {words.begin(), words.end()}, {}, 0};
    row.measure(overhead);
    if (!band.runs.empty() && !row.runs.empty()) {
      Band both = joined(band, row, overhead);
      if (both.cost <= band.cost + row.cost) {
        band = std::move(both);
        continue;
      }
    }
    close();
    band = std::move(row);
  }
  close();
  return out;
}

}  // namespace weftlight::cloth
