#include "texture_set/tile.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace weftlight::texture_set {

using cloth::ClothLayer, cloth::Period, cloth::ThreadBody, cloth::lay_out;
using design::Twist, design::Yarn;

namespace {

constexpr size_t kMaxTileThreads = 8192;  // per system, in a tile of several repeats
constexpr int kPartThreads = 32;          // per system, enough for a mean over the irregularities of the yarns
constexpr size_t kMaxWholeThreads = 64;   // per system, of a tile that is measured as a whole

// Of kTileOfYarns.
constexpr float kYarnTile_mm = 50;     // five slubs (shaders/thread_thickness.glsl) along each thread
constexpr float kTexelsPerThread = 6;  // at least, so that threads can still be seen
// Filament yarns have a CV of 2 to 5 %, the most even combed cotton about 10 (Uster Statistics).
constexpr float kEvenYarn = 6;
constexpr float kVisibleMelange = 0.05f;

bool varies(const Yarn& yarn) { return yarn.unevenness > kEvenYarn || yarn.melange > kVisibleMelange; }

int repeats_for(float mm, float tile_mm, size_t threads) {
  const int repeats = static_cast<int>(std::ceil(tile_mm / std::max(mm, 1e-3f) - 1e-3f));
  const int max_repeats = static_cast<int>(std::max<size_t>(kMaxTileThreads / std::max<size_t>(threads, 1), 1));
  return std::clamp(repeats, 1, max_repeats);
}

/// Repeats of a part with about kPartThreads.
int part_of(int repeats, size_t threads) {
  return std::clamp(kPartThreads / static_cast<int>(std::max<size_t>(threads, 1)), 1, repeats);
}

/// Repeated threads, layer by layer. from: index of the original thread.
struct RepeatedThreads {
  std::vector<ThreadBody> threads;
  std::vector<int> from;
};

RepeatedThreads repeated(const std::vector<ThreadBody>& threads, const std::vector<std::pair<int, int>>& runs,
                         int times, float period_mm) {
  RepeatedThreads out;
  for (const auto& [first, count] : runs) {
    for (int k = 0; k < times; ++k) {
      for (int i = first; i < first + count; ++i) {
        ThreadBody t = threads[static_cast<size_t>(i)];
        t.centre_mm += static_cast<float>(k) * period_mm;
        out.threads.push_back(t), out.from.push_back(i);
      }
    }
  }
  return out;
}

Cloth repeat_of(const Design& design, const BitMatrix& cells, Face face) {
  Cloth cloth = lay_out(design, cells, face, Period::kRepeat);
  // The images of the back are mirrored: with the opposite twist in them, the twist on the cloth is right.
  for (Yarn& yarn : cloth.yarns) {
    if (face == Face::kFront) break;
    yarn.twist = yarn.twist == Twist::kS ? Twist::kZ : yarn.twist == Twist::kZ ? Twist::kS : Twist::kNone;
  }
  return cloth;
}

}  // namespace

Cloth tiled(const Cloth& cloth, int across, int up) {
  std::vector<std::pair<int, int>> end_runs{{0, cloth.up.cols()}}, pick_runs{{0, cloth.up.rows()}};
  if (!cloth.layers.empty()) end_runs.clear(), pick_runs.clear();
  Cloth out = cloth;
  for (ClothLayer& l : out.layers) {
    end_runs.emplace_back(l.first_end, l.ends), pick_runs.emplace_back(l.first_pick, l.picks);
    l = {l.first_end * across, l.ends * across, l.first_pick * up, l.picks * up};
  }
  const RepeatedThreads ends = repeated(cloth.ends, end_runs, across, cloth.width_mm),
                        picks = repeated(cloth.picks, pick_runs, up, cloth.depth_mm);
  out.width_mm *= static_cast<float>(across), out.depth_mm *= static_cast<float>(up);
  out.ends = ends.threads, out.picks = picks.threads;
  out.up = BitMatrix(cloth.up.rows() * up, cloth.up.cols() * across);
  for (const auto of : cloth::kCrossingValues) (out.*of).clear();
  for (int pick = 0; pick < out.up.rows(); ++pick) {
    for (int end = 0; end < out.up.cols(); ++end) {
      const int p = picks.from[static_cast<size_t>(pick)], e = ends.from[static_cast<size_t>(end)];
      out.up.set(pick, end, cloth.up.get(p, e));
      const size_t at = static_cast<size_t>(p) * static_cast<size_t>(cloth.up.cols()) + static_cast<size_t>(e);
      for (const auto of : cloth::kCrossingValues)
        if (!(cloth.*of).empty()) (out.*of).push_back((cloth.*of)[at]);
    }
  }
  return out;
}

float tile_mm_for(const Cloth& repeat, int size) {
  const auto uses_varying = [&](const std::vector<ThreadBody>& threads) {
    return std::ranges::any_of(threads,
                               [&](const ThreadBody& t) { return varies(repeat.yarns[static_cast<size_t>(t.yarn)]); });
  };
  if (!uses_varying(repeat.ends) && !uses_varying(repeat.picks)) return 0;
  const float spacing_mm = std::min(repeat.width_mm / static_cast<float>(std::max<size_t>(repeat.ends.size(), 1)),
                                    repeat.depth_mm / static_cast<float>(std::max<size_t>(repeat.picks.size(), 1)));
  const float room_mm = static_cast<float>(size) / kTexelsPerThread * spacing_mm;
  // Whole repeats are rounded up, which the room must allow.
  const float spare_mm = std::max(repeat.width_mm, repeat.depth_mm);
  return std::clamp(room_mm - spare_mm, 0.0f, kYarnTile_mm);
}

Tile make_tile(const Design& design, const BitMatrix& cells, Face face, float tile_mm, int size) {
  Tile tile{repeat_of(design, cells, face)};
  const float least_mm = tile_mm < 0 ? tile_mm_for(tile.cloth, size) : tile_mm;
  if (least_mm <= 0) return tile;
  const Cloth repeat = std::move(tile.cloth);
  const size_t ends = repeat.ends.size(), picks = repeat.picks.size();
  tile.across = repeats_for(repeat.width_mm, least_mm, ends);
  tile.up = repeats_for(repeat.depth_mm, least_mm, picks);
  tile.cloth = tiled(repeat, tile.across, tile.up);
  if (std::max(tile.cloth.ends.size(), tile.cloth.picks.size()) <= kMaxWholeThreads) return tile;
  tile.part_across = part_of(tile.across, ends), tile.part_up = part_of(tile.up, picks);
  if (tile.part_across < tile.across || tile.part_up < tile.up)
    tile.part = tiled(repeat, tile.part_across, tile.part_up);
  return tile;
}

}  // namespace weftlight::texture_set
