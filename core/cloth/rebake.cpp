// Rebakes maps after a change of cells, at a cost that follows the change. Changed cells move the heights of the
// crossings whose floats they begin, end or split; those move the curves through them; the curves are visible in
// texels, whose heights the horizon sweeps read. Each step keeps a bit set instead of a bounding rectangle, since the
// cells of one shaft or one lift are scattered over the cloth.

#include <bit>
#include <cmath>

#include "base/loops.h"
#include "cloth/bake_parts.h"
#include "cloth/texel_cover.h"
#include "cloth/thickness.h"

namespace weftlight::cloth {

using base::for_each_job;
using draft::BitMatrix, draft::System, draft::for_each_bit;

namespace {

// Overhead of a rectangle in texels: to set up a sampler, and to upload a patch.
constexpr int kSamplerOverhead = 40, kPatchOverhead = 256;
// The same of a window of maps, with the run-ups of its horizons.
constexpr int kWindowOverhead = 1 << 14;
constexpr int kLargestPart = 128;        // texels a side of a part; parts run in parallel
constexpr int64_t kWorthAThread = 4096;  // texels that are worth a second thread

/// Crossings whose height changed, picks x ends.
struct MovedCrossings {
  BitMatrix warp, weft;
};

/// Marks the crossings from (pick, end) on in one direction whose heights depend on that float.
void mark_readers(BitMatrix& moved, const BitMatrix& up, int pick, int end, int d_pick, int d_end) {
  const auto at = [&](int n) {
    return std::pair{wrap(pick + n * d_pick, up.rows()), wrap(end + n * d_end, up.cols())};
  };
  const auto [first_pick, first_end] = at(1);
  const bool side = up.get(first_pick, first_end);
  for (int n = 1; n <= kFloatReach; ++n) {
    const auto [p, e] = at(n);
    if (up.get(p, e) != side) return;
    moved.set(p, e, true);
  }
}

/// Marks the crossings that washing moves differently.
void mark_changed(BitMatrix& moved, const std::vector<float>& before, const std::vector<float>& after) {
  if (before.empty() && after.empty()) return;
  const auto value = [](const std::vector<float>& of, size_t at) { return of.empty() ? 0.0f : of[at]; };
  size_t at = 0;
  for (int p = 0; p < moved.rows(); ++p)
    for (int e = 0; e < moved.cols(); ++e, ++at)
      if (value(before, at) != value(after, at)) moved.set(p, e, true);
}

MovedCrossings moved_crossings(const BitMatrix& before, const BitMatrix& after) {
  const int picks = after.rows(), ends = after.cols();
  MovedCrossings moved{BitMatrix(picks, ends), BitMatrix(picks, ends)};
  for (int p = 0; p < picks; ++p) {
    const auto was = before.row(p), is = after.row(p);
    for (size_t w = 0; w < is.size(); ++w) {
      for (uint64_t changed = was[w] ^ is[w]; changed; changed &= changed - 1) {
        const int e = static_cast<int>(w) * 64 + std::countr_zero(changed);
        moved.warp.set(p, e, true), moved.weft.set(p, e, true);
        for (const BitMatrix* up : {&before, &after}) {
          for (const int d : {-1, 1}) {
            mark_readers(moved.warp, *up, p, e, d, 0);
            mark_readers(moved.weft, *up, p, e, 0, d);
          }
        }
      }
    }
  }
  return moved;
}

/// Texels [first, second) of samples [from, to).
std::pair<int, int> texels_of(int from, int to, int per_texel) {
  return from < to ? std::pair{from / per_texel, (to + per_texel - 1) / per_texel} : std::pair{0, 0};
}

/// Texels along an axis that show the threads [first, last). aside: of how many more on each side they may take room.
std::vector<std::pair<int, int>> texels_of_threads(const SampleAxis& axis, int first, int last, int aside) {
  std::vector<std::pair<int, int>> out;
  for (const auto& [a, b] : pieces(first - aside, last + aside, static_cast<int>(axis.thread_from.size()) - 1))
    out.push_back(
        texels_of(axis.thread_from[static_cast<size_t>(a)], axis.thread_from[static_cast<size_t>(b)], axis.per_texel));
  return out;
}

/// Texels along an axis whose curves depend on the crossings [first, last): a curve reads one crossing before its step
/// and two after. aside: 1 if the crossings may be moved sideways.
std::vector<std::pair<int, int>> texels_of_curves(const SampleAxis& axis, int first, int last, int aside) {
  const int n = static_cast<int>(axis.crossing_from.size()) - 1;
  std::vector<std::pair<int, int>> out;
  for (const auto& [a, b] : pieces(first - 2 - aside, last + 1 + aside, n)) {
    out.push_back(texels_of(axis.crossing_from[static_cast<size_t>(a)], axis.crossing_from[static_cast<size_t>(b)],
                            axis.per_texel));
    // Before the first crossing lies the step from the last crossing of the previous period.
    if (b == n) out.push_back(texels_of(0, axis.crossing_from[0], axis.per_texel));
  }
  return out;
}

/// Calls visit(first, last) for each run of set bits of a row.
template <class Visit>
void for_each_run(std::span<const uint64_t> row, const Visit& visit) {
  int first = -1, last = -1;
  for_each_bit(row, [&](int at) {
    if (at != last) {
      if (first >= 0) visit(first, last);
      first = at;
    }
    last = at + 1;
  });
  if (first >= 0) visit(first, last);
}

using Runs = std::vector<std::pair<int, int>>;

void mark(BitMatrix& texels, const Runs& columns, const Runs& rows) {
  for (const auto& [y0, y1] : rows)
    for (int y = y0; y < y1; ++y)
      for (const auto& [x0, x1] : columns) set_run(texels.row(y), x0, x1);
}

/// Texels in which a moved curve is visible.
BitMatrix seen_in(const MovedCrossings& moved, const Cloth& cloth, const SampleGrid& grid) {
  BitMatrix texels(grid.height, grid.width);
  const SampleAxis columns = sample_axis(cloth, System::kWarp, grid), rows = sample_axis(cloth, System::kWeft, grid);
  const int aside_of_ends = uneven(cloth, System::kWarp) ? 1 : 0, aside_of_picks = uneven(cloth, System::kWeft) ? 1 : 0;
  const int moved_aside = cloth.warp_aside_mm.empty() ? 0 : 1;
  for (int p = 0; p < moved.warp.rows(); ++p) {
    for_each_run(moved.warp.row(p), [&](int first, int last) {
      mark(texels, texels_of_threads(columns, first, last, aside_of_ends),
           texels_of_curves(rows, p, p + 1, moved_aside));
    });
    for_each_run(moved.weft.row(p), [&](int first, int last) {
      mark(texels, texels_of_curves(columns, first, last, moved_aside),
           texels_of_threads(rows, p, p + 1, aside_of_picks));
    });
  }
  return texels;
}

/// Cuts rectangles into parts of a size worth a thread.
std::vector<TexelRect> parts_of(const std::vector<TexelRect>& rects) {
  std::vector<TexelRect> parts;
  for (const TexelRect& r : rects)
    for (int y = r.y0; y < r.y1; y += kLargestPart)
      for (int x = r.x0; x < r.x1; x += kLargestPart)
        parts.push_back({x, y, std::min(r.x1, x + kLargestPart), std::min(r.y1, y + kLargestPart)});
  return parts;
}

/// Rebakes the surface inside the rectangles.
void rebake_surface(Maps& maps, const Cloth& cloth, const SampleGrid& grid, const std::vector<TexelRect>& rects) {
  int64_t texels = 0;
  for (const TexelRect& r : rects) texels += int64_t{r.x1 - r.x0} * (r.y1 - r.y0);
  const std::vector<TexelRect> parts = parts_of(rects);
  for_each_job(static_cast<int>(parts.size()), texels < kWorthAThread ? 1 : 0,
               [&](int i) { bake_surface(maps, cloth, grid, parts[static_cast<size_t>(i)]); });
}

/// Lines of one sweep that read a changed texel: blocks x lines.
BitMatrix lines_through(const Sweep& s, const std::vector<TexelRect>& changed) {
  BitMatrix lines(s.blocks(), s.lines);
  const auto shift = [&](int i) { return static_cast<int>(std::floor(i * s.shear)); };
  for (const TexelRect& r : changed) {
    const int a0 = s.along_x ? r.x0 : r.y0, a1 = s.along_x ? r.x1 : r.y1;
    const int c0 = s.along_x ? r.y0 : r.x0, c1 = s.along_x ? r.y1 : r.x1;
    for (int b = 0; b < s.blocks(); ++b) {
      const int from = b * s.block, to = std::min(s.length, from + s.block);
      // The run-up may leave the period at either side.
      for (const int turn : {-s.length, 0, s.length}) {
        const int i0 = std::max(a0 + turn, s.forward ? from : from - s.ahead);
        const int i1 = std::min(a1 + turn, s.forward ? to + s.ahead : to);
        if (i0 >= i1) continue;
        const int low = std::min(shift(i0), shift(i1 - 1)), high = std::max(shift(i0), shift(i1 - 1));
        // A line reads two texels and its value reaches two.
        for (const auto& [line0, line1] : pieces(c0 - high - 2, c1 - low + 2, s.lines))
          set_run(lines.row(b), line0, line1);
      }
    }
  }
  return lines;
}

/// Calls visit(block, first line, last line) for each run of lines that the changed heights affect.
template <class Visit>
void for_each_swept(const Sweep& s, const std::vector<TexelRect>& changed, const Visit& visit) {
  const BitMatrix lines = lines_through(s, changed);
  for (int b = 0; b < s.blocks(); ++b)
    for_each_run(lines.row(b), [&](int line0, int line1) { visit(b, line0, line1); });
}

/// The texels of lines of a block, not wrapped.
TexelRect swept_texels(const Sweep& s, int block, int line0, int line1) {
  const auto shift = [&](int i) { return static_cast<int>(std::floor(i * s.shear)); };
  const int from = block * s.block, to = std::min(s.length, from + s.block);
  const int side0 = line0 + std::min(shift(from), shift(to - 1)), side1 = line1 + std::max(shift(from), shift(to - 1));
  return s.along_x ? TexelRect{from, side0, to, side1} : TexelRect{side0, from, side1, to};
}

/// Sweeps again the lines that the changed heights affect.
void resweep(Maps& maps, const Sweep& s, int k, const std::vector<TexelRect>& changed) {
  const int w = maps.height_mm.width;
  const auto height = view_along<const float>(s, maps.height_mm.row(0), w);
  const auto out = view_along(s, maps.horizon[static_cast<size_t>(k)].row(0), w);
  for_each_swept(s, changed,
                 [&](int block, int line0, int line1) { sweep_block(s, height, line0, line1, block, out); });
}

/// Texels whose surface a change of cells affects.
BitMatrix changed_surface(const Cloth& before, const Cloth& after, const SampleGrid& grid) {
  MovedCrossings moved = moved_crossings(before.up, after.up);
  mark_changed(moved.warp, before.warp_level_mm, after.warp_level_mm);
  mark_changed(moved.weft, before.weft_level_mm, after.weft_level_mm);
  // Where a thread is moved, those that cross it have their crossings elsewhere.
  for (BitMatrix* of : {&moved.warp, &moved.weft}) {
    mark_changed(*of, before.warp_aside_mm, after.warp_aside_mm);
    mark_changed(*of, before.weft_aside_mm, after.weft_aside_mm);
  }
  return seen_in(moved, after, grid);
}

/// Adds the texels whose horizons the changed heights affect.
void add_swept(BitMatrix& touched, const Cloth& cloth, int azimuths, const std::vector<TexelRect>& changed) {
  const int w = touched.cols(), h = touched.rows();
  std::vector<std::vector<TexelRect>> swept(static_cast<size_t>(azimuths));
  for_each_job(azimuths, [&](int k) {
    const Sweep s = sweep_of(cloth, w, h, azimuths, k);
    for_each_swept(s, changed, [&](int block, int line0, int line1) {
      swept[static_cast<size_t>(k)].push_back(swept_texels(s, block, line0, line1));
    });
  });
  for (const auto& rects : swept)
    for (const TexelRect& rect : rects)
      for (const TexelRect& r : pieces(rect, w, h)) mark(touched, Runs{{r.x0, r.x1}}, Runs{{r.y0, r.y1}});
}

/// Whole pairs of texels along both sides, as horizons are packed.
BitMatrix in_pairs(const BitMatrix& texels) {
  const int w = texels.cols(), h = texels.rows();
  BitMatrix out(h, w);
  for (int y = 0; y < h; ++y)
    for_each_run(texels.row(y), [&](int first, int last) {
      for (const int row : {y & ~1, std::min(y | 1, h - 1)})
        set_run(out.row(row), first & ~1, std::min((last + 1) & ~1, w));
    });
  return out;
}

bool differ(const Cloth& before, const Cloth& after) {
  return !is_empty(after) && (before.up != after.up || before.layers != after.layers);
}

/// Whether a cell may connect separate layers, or separate them: then everything may change.
bool layered(const Cloth& before, const Cloth& after) { return !before.layers.empty() || !after.layers.empty(); }

}  // namespace

std::vector<TexelRect> rebake(Maps& maps, const Cloth& before, const Cloth& after) {
  if (!differ(before, after)) return {};
  const int w = maps.height_mm.width, h = maps.height_mm.height;
  if (layered(before, after)) {
    maps = bake(after, {w, h, maps.azimuths});
    return {{0, 0, w, h}};
  }
  const SampleGrid grid = sample_grid(after, w, h);
  BitMatrix touched = changed_surface(before, after, grid);
  const std::vector<TexelRect> changed = cover(touched, kSamplerOverhead);
  rebake_surface(maps, after, grid, changed);
  if (maps.azimuths == 0) return cover(touched, kPatchOverhead);
  for_each_job(maps.azimuths, [&](int k) { resweep(maps, sweep_of(after, w, h, maps.azimuths, k), k, changed); });
  add_swept(touched, after, maps.azimuths, changed);
  std::vector<TexelRect> all = cover(touched, kPatchOverhead);
  for (const TexelRect& r : all) bake_occlusion(maps, r);
  return all;
}

std::vector<TexelRect> bake_changed(Maps& maps, const Cloth& before, const Cloth& after, const MapsSize& size) {
  if (!differ(before, after)) return {};
  const int w = size.width, h = size.height;
  std::vector<TexelRect> rects;
  int64_t texels = int64_t{w} * h;
  if (!layered(before, after)) {
    BitMatrix touched = changed_surface(before, after, sample_grid(after, w, h));
    if (size.azimuths > 0) add_swept(touched, after, size.azimuths, cover(touched, kSamplerOverhead));
    rects = cover(in_pairs(touched), kWindowOverhead);
    texels = 0;
    for (const TexelRect& r : rects) texels += int64_t{r.x1 - r.x0} * (r.y1 - r.y0);
  }
  if (2 * texels > int64_t{w} * h) {
    maps = {};  // freed before the new ones take their memory
    maps = bake(after, size);
    return {{0, 0, w, h}};
  }
  if (maps.height_mm.width != w || maps.height_mm.height != h) maps = blank_maps(size);
  maps.width_mm = after.width_mm, maps.depth_mm = after.depth_mm;
  for (const TexelRect& r : rects) copy_window(maps, bake(after, size, r), r);
  return rects;
}

}  // namespace weftlight::cloth
