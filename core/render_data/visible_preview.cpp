#include "render_data/visible_preview.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "cloth/thread_scene.h"
#include "render_data/face_cloth.h"
#include "render_data/thread_block.h"

namespace weftlight::render_data {

using cloth::Cloth, cloth::MapsSize, cloth::Period, cloth::TexelRect, cloth::ThreadBody, cloth::highest_thread,
    cloth::thread_crossings;
using draft::BitMatrix, draft::CellRect, draft::Draft, draft::Face, draft::differences, draft::update_drawdown;

namespace {

// Changed all over the cloth: updating the maps would take too long to be interactive.
constexpr int kManyCrossings = 2000;
constexpr int64_t kMaxVisible = 1 << 18;  // texels, or crossings, of a preview
constexpr int kPreviewLevels = 4,
              kPreviewStep = 1 << kPreviewLevels;  // levels of a part of the maps, which is aligned to whole texels

/// The part of [from, to) within a period of `length`; all of it if that crosses the end.
struct Run {
  double from, to;
};
Run in_period(double from, double to, double length) {
  const double start = from - std::floor(from / length) * length;
  if (to - from >= length || start + (to - from) > length) return {0, length};
  return {start, start + (to - from)};
}

/// Moves the levels of a texture, from the finest on, into patches of the front's texture at `level` and above.
void append_levels(std::vector<PackedPatch>& to, PackedTexture& t, const TexelRect& window, int level, int levels) {
  for (int k = 0; k < std::min(levels, static_cast<int>(t.levels.size())); ++k)
    to.push_back({Face::kFront, t.kind, level + k, window.x0 >> k, window.y0 >> k, t.level_width(k), t.level_height(k),
                  std::move(t.levels[static_cast<size_t>(k)])});
}

/// The level for the pixel size and those above it, or the finest one that can be baked at once.
void bake_maps(const PackedFace& front, const Cloth& cloth, const VisiblePart& visible, StageResult& result) {
  const PackedTexture& shown = front.textures[0];
  const double period[] = {static_cast<double>(cloth.width_mm), static_cast<double>(cloth.depth_mm)};
  const Run u = in_period(static_cast<double>(visible.u0), static_cast<double>(visible.u1), period[0]);
  const Run v = in_period(static_cast<double>(visible.v0), static_cast<double>(visible.v1), period[1]);
  for (int level = 0; level + kPreviewLevels < static_cast<int>(shown.levels.size()); ++level) {
    const int w = shown.level_width(level), h = shown.level_height(level);
    const auto texels = [](double from, double to, double length, int n) {
      const int low = static_cast<int>(from / length * n) / kPreviewStep * kPreviewStep;
      const int high = (static_cast<int>(std::ceil(to / length * n)) + kPreviewStep - 1) / kPreviewStep * kPreviewStep;
      return std::pair{std::min(low, n - 1), std::clamp(high, std::min(low, n - 1) + 1, n)};
    };
    const auto [x0, x1] = texels(u.from, u.to, period[0], w);
    const auto [y0, y1] = texels(v.from, v.to, period[1], h);
    const double texel_mm = std::min(period[0] / w, period[1] / h);
    if (2 * texel_mm <= static_cast<double>(visible.pixel_mm) || int64_t{x1 - x0} * (y1 - y0) > kMaxVisible) continue;
    const MapsSize size{w, h, front.textures[static_cast<size_t>(PackedKind::kHorizon)].layers - 1};
    PackedFace part = pack(bake_quick(cloth, size, {x0, y0, x1, y1}), false);
    const bool whole = x1 - x0 == w && y1 - y0 == h;
    for (PackedTexture& t : part.textures) {
      if (t.layers == 0) continue;
      const bool half = t.kind == PackedKind::kHorizon;
      append_levels(result.patches.maps, t,
                    half ? TexelRect{x0 / 2, y0 / 2, x1 / 2, y1 / 2} : TexelRect{x0, y0, x1, y1}, level,
                    whole  ? static_cast<int>(t.levels.size())
                    : half ? kPreviewLevels - 1
                           : kPreviewLevels);
    }
    return;
  }
}

/// Crossings of the preview, if few enough are visible to be drawn thread by thread.
void bake_crossings(const StageData& data, const Cloth& cloth, const VisiblePart& visible, StageResult& result) {
  if (!data.packed.has_threads()) return;
  const auto among = [](const std::vector<ThreadBody>& threads, const Run& run) {
    const auto at = [&](double mm) {
      return static_cast<int>(
          std::ranges::partition_point(threads,
                                       [mm](const ThreadBody& t) { return static_cast<double>(t.centre_mm) < mm; }) -
          threads.begin());
    };
    constexpr int kMargin = 2;
    const int n = static_cast<int>(threads.size());
    return std::pair{std::max(0, at(run.from) - kMargin), std::min(n, at(run.to) + kMargin)};
  };
  const double width = static_cast<double>(cloth.width_mm), depth = static_cast<double>(cloth.depth_mm);
  const auto [e0, e1] =
      among(cloth.ends, in_period(static_cast<double>(visible.u0), static_cast<double>(visible.u1), width));
  const auto [p0, p1] =
      among(cloth.picks, in_period(static_cast<double>(visible.v0), static_cast<double>(visible.v1), depth));
  const CellRect cells{e0, e1, p0, p1};
  // Other shaders draw threads that are moved sideways.
  if (cloth.warp_aside_mm.empty() != data.packed.asides.empty()) return;
  if (cells.empty() || int64_t{e1 - e0} * (p1 - p0) > kMaxVisible) return;
  if (!data.packed.strips.empty()) {  // their bound of the heights holds for any weave
    std::ranges::move(cell_strips(cloth.up, cells), std::back_inserter(result.patches.strips));
    return;
  }
  const std::vector<glm::vec4> crossings = thread_crossings(cloth, cells);
  result.patches.crossings.push_back({cells, packed_crossings(crossings), packed_asides(cloth, cells)});
  const float top_mm = highest_thread(cloth, crossings);
  if (top_mm <= data.top_mm) return;
  result.lobes = data.packed.lobes;
  result.lobes->threads = thread_records(cloth, top_mm);
}

/// Whether the maps exist, and only crossings differ.
bool can_preview(const StageData& data, const Design& before, const Design& now) {
  if (data.coarse || data.period != Period::kWholeDraft || !data.faces[0].cloth.layers.empty()) return false;
  if (data.packed.front.textures[0].width == 0 || data.packed.front.cube_size > 0) return false;
  const Draft &a = before.draft, &b = now.draft;
  return a.ends() == b.ends() && a.picks() == b.picks() && a.warp == b.warp && a.weft == b.weft &&
         a.palette == b.palette && before.yarns == now.yarns && before.finish == now.finish &&
         same_shrinkage(before.plan, now.plan);
}

}  // namespace

bool preview_visible(const StageData& data, const Design& before, const Design& now, const VisiblePart& visible,
                     bool again, StageResult& result) {
  if (visible.empty() || !can_preview(data, before, now) || (!again && before.draft == now.draft)) return false;
  BitMatrix cells = data.cells;
  update_drawdown(cells, data.drawn->draft, now.draft);
  int64_t changed = 0;
  for (int p = 0; p < cells.rows(); ++p) changed += differences(cells.row(p), data.cells.row(p));
  if (changed < kManyCrossings && !again) return false;
  const Cloth cloth = face_cloth(now, cells, Face::kFront, data.period);
  if (!same_layout(data.faces[0].cloth, cloth)) return false;
  bake_maps(data.packed.front, cloth, visible, result);
  bake_crossings(data, cloth, visible, result);
  return true;
}

}  // namespace weftlight::render_data
