#include <algorithm>
#include <cmath>

#include "print/page.h"

namespace weftlight::print {
namespace {

/// Edges of the threads of a system, mm: one more than threads.
std::vector<double> edges(const Design& design, const Threads& threads) {
  std::vector<double> at{0};
  for (size_t i = 0; i < threads.color.size(); ++i) {
    const float own = threads.thickness_mm[i];
    const float thick = own >= 0 ? own : design.yarns[static_cast<size_t>(threads.yarn[i])].diameter_mm;
    const float spacing = threads.spacing_mm[i] >= 0 ? threads.spacing_mm[i] : thick;
    at.push_back(at.back() + std::max(static_cast<double>(spacing), 0.01));
  }
  return at;
}

/// The thread at a pixel, and the distance from its middle, -1..1.
struct ThreadAt {
  int thread = 0;
  double off = 0;
};
std::vector<ThreadAt> threads_at(const std::vector<double>& edge, int count, double pixels_per_mm) {
  std::vector<ThreadAt> out;
  for (int i = 0; i < count; ++i) {
    const double mm = std::fmod((i + 0.5) / pixels_per_mm, edge.back());
    const auto next = std::upper_bound(edge.begin(), edge.end(), mm);
    const auto thread = std::min(static_cast<size_t>(next - edge.begin()), edge.size() - 1) - 1;
    const double width = edge[thread + 1] - edge[thread];
    out.push_back({static_cast<int>(thread), (mm - edge[thread]) / width * 2 - 1});
  }
  return out;
}

uint32_t shaded(const Rgb& c, double off) {
  const double shade = 0.5 + 0.5 * std::sqrt(std::max(0.0, 1 - off * off * 0.96));
  const auto byte = [shade](float channel) {
    return static_cast<uint32_t>(std::clamp(static_cast<double>(channel) * shade, 0.0, 1.0) * 255 + 0.5);
  };
  return byte(c.r) << 16 | byte(c.g) << 8 | byte(c.b);
}

}  // namespace

std::vector<uint32_t> swatch_pixels(const Design& design, const BitMatrix& cells, int width, int height,
                                    double pixels_per_mm) {
  const Draft& d = design.draft;
  std::vector<uint32_t> out(static_cast<size_t>(width) * static_cast<size_t>(height), 0xffffff);
  if (d.ends() == 0 || d.picks() == 0) return out;
  const auto across = threads_at(edges(design, d.warp), width, pixels_per_mm);
  const auto down = threads_at(edges(design, d.weft), height, pixels_per_mm);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const ThreadAt &end = across[static_cast<size_t>(x)], &pick = down[static_cast<size_t>(y)];
      const bool up = cells.get(pick.thread, end.thread);
      const int color =
          up ? d.warp.color[static_cast<size_t>(end.thread)] : d.weft.color[static_cast<size_t>(pick.thread)];
      out[static_cast<size_t>(y) * static_cast<size_t>(width) + static_cast<size_t>(x)] =
          shaded(d.palette[static_cast<size_t>(color)], up ? end.off : pick.off);
    }
  return out;
}

}  // namespace weftlight::print
