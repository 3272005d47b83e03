#include "views/common/cell_image.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace weftlight::views {
namespace {

constexpr int kSamples = 4;  // along each side of a pixel that covers several cells

struct Mean {
  uint32_t r = 0, g = 0, b = 0, n = 0;
  void add(ImU32 c) {
    r += (c >> IM_COL32_R_SHIFT) & 255;
    g += (c >> IM_COL32_G_SHIFT) & 255;
    b += (c >> IM_COL32_B_SHIFT) & 255;
    ++n;
  }
  ImU32 color() const { return n == 0 ? 0 : IM_COL32(r / n, g / n, b / n, 255); }
};

using Samples = std::array<int, kSamples>;

/// Cells sampled by each pixel along an axis; -1: none. One sample where a pixel lies within a cell.
std::vector<Samples> samples_along(const Axis& axis, int pixels, bool tiled) {
  std::vector<Samples> all(static_cast<size_t>(pixels));
  const int n = axis.pitch >= 1 ? 1 : kSamples;
  const auto cell = [&](float pixel) {
    if (!tiled || axis.count == 0) return axis.at(pixel);
    const int at = cell_at(axis, pixel) % axis.count;
    return at < 0 ? at + axis.count : at;
  };
  for (int p = 0; p < pixels; ++p) {
    all[static_cast<size_t>(p)].fill(-1);
    for (int k = 0; k < n; ++k)
      all[static_cast<size_t>(p)][static_cast<size_t>(k)] =
          cell(axis.start + static_cast<float>(p) + (static_cast<float>(k) + 0.5f) / static_cast<float>(n));
  }
  return all;
}

}  // namespace

std::vector<ImU32> thread_colors(const Draft& draft, System system) {
  std::vector<ImU32> out;
  for (int color : draft.threads(system).color) out.push_back(to_u32(draft.palette[static_cast<size_t>(color)]));
  return out;
}

CellImage cell_image(const Draft& draft, const BitMatrix& cells, Face face, DrawdownStyle look, const Colors& colors,
                     const Axis& ends, const Axis& picks, bool tiled) {
  CellImage image{static_cast<int>(ends.length), static_cast<int>(picks.length), {}};
  image.pixels.resize(static_cast<size_t>(image.width) * static_cast<size_t>(image.height));
  const bool structure = look == DrawdownStyle::kStructure;
  const auto warp = structure ? std::vector<ImU32>(static_cast<size_t>(draft.ends()), colors.ink)
                              : thread_colors(draft, System::kWarp);
  const auto weft = structure ? std::vector<ImU32>(static_cast<size_t>(draft.picks()), colors.paper)
                              : thread_colors(draft, System::kWeft);
  const auto across = samples_along(ends, image.width, tiled), down = samples_along(picks, image.height, tiled);
  size_t at = 0;
  for (const Samples& rows : down)
    for (const Samples& columns : across) {
      Mean mean;
      for (int pick : rows)
        for (int end : columns)
          if (pick >= 0 && end >= 0)
            mean.add(warp_on_top(cells, face, end, pick) ? warp[static_cast<size_t>(end)]
                                                         : weft[static_cast<size_t>(pick)]);
      image.pixels[at++] = mean.color();
    }
  return image;
}

}  // namespace weftlight::views
