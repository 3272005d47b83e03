#include "views/common/cell_image.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace weftlight::views {

using ui::cell_at;

namespace {

constexpr int kSamples = 4;  // per axis, in a pixel that covers several cells

/// Red, green, blue and a count, 16 bits each: one addition sums all four, for up to 256 colours.
using Lanes = uint64_t;

Lanes lanes_of(ImU32 c) {
  const auto channel = [c](int shift) { return Lanes{(c >> shift) & 255}; };
  return channel(IM_COL32_R_SHIFT) | channel(IM_COL32_G_SHIFT) << 16 | channel(IM_COL32_B_SHIFT) << 32 | Lanes{1} << 48;
}

ImU32 mean_of(Lanes sum) {
  const uint32_t n = static_cast<uint32_t>(sum >> 48);
  const auto channel = [&](int shift) { return static_cast<uint32_t>(sum >> shift & 0xFFFF) / n; };
  return n == 0 ? 0 : IM_COL32(channel(0), channel(16), channel(32), 255);
}

std::vector<Lanes> lanes_of(const std::vector<ImU32>& colors) {
  std::vector<Lanes> out;
  out.reserve(colors.size());
  for (const ImU32 c : colors) out.push_back(lanes_of(c));
  return out;
}

using Samples = std::array<int, kSamples>;

/// Cells sampled by each pixel along an axis, -1 for none. One sample if cells are at least as large as pixels.
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

CellImage cell_image(const design::Design& design, const BitMatrix& cells, Face face, DrawdownStyle style,
                     const Colors& colors, const Axis& ends, const Axis& picks, bool tiled) {
  CellImage image{static_cast<int>(ends.length), static_cast<int>(picks.length), {}};
  image.pixels.resize(static_cast<size_t>(image.width) * static_cast<size_t>(image.height));
  const CrossingColors threads =
      style == DrawdownStyle::kStructure ? two_colors(design.draft, colors.ink, colors.paper) : crossing_colors(design);
  const auto across = samples_along(ends, image.width, tiled), down = samples_along(picks, image.height, tiled);
  const std::vector<Lanes> warp_lanes = lanes_of(threads.warp), weft_lanes = lanes_of(threads.weft);
  const bool dyed = !threads.dyed.empty();
  const uint64_t flip = face == Face::kBack ? 1 : 0;
  size_t at = 0;
  for (const Samples& rows : down)
    for (const Samples& columns : across) {
      Lanes sum = 0;
      for (const int pick : rows) {
        if (pick < 0) continue;
        const uint64_t* row = cells.row(pick).data();
        const Lanes below = weft_lanes[static_cast<size_t>(pick)];
        for (const int end : columns) {
          if (end < 0) continue;
          const uint64_t up = (row[end >> 6] >> (end & 63) & 1) ^ flip;
          if (dyed) sum += lanes_of(up ? threads.of(System::kWarp, end, pick) : threads.of(System::kWeft, pick, end));
          else sum += up ? warp_lanes[static_cast<size_t>(end)] : below;
        }
      }
      image.pixels[at++] = mean_of(sum);
    }
  return image;
}

}  // namespace weftlight::views
