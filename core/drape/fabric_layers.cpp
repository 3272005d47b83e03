#include "drape/fabric_layers.h"

#include <algorithm>

namespace weftlight::drape {

namespace {

constexpr float kLayer = 1.1f;  // thickness of a second layer with its turned edges, mm

}  // namespace

std::vector<Knot> knots(float from, float to, float stitch_from, float stitch_to, float step_mm) {
  std::vector<Knot> out{{from, 0.06f}, {from + 0.8f, 1}};
  const auto stitch = [&](float at) { out.insert(out.end(), {{at - 0.9f, 1}, {at, 0.35f}, {at + 0.9f, 1}}); };
  if (stitch_from > 0) stitch(from + stitch_from);
  const float begin = out.back().at_mm, end = to - (stitch_to > 0 ? stitch_to + 0.9f : 0.8f);
  const int steps = std::max(1, static_cast<int>((end - begin) / step_mm));
  for (int k = 1; k < steps; ++k)
    out.push_back({mix(begin, end, static_cast<float>(k) / static_cast<float>(steps)), 1});
  if (stitch_to > 0) stitch(to - stitch_to);
  else out.push_back({to - 0.8f, 1});
  out.push_back({to, 0.06f});
  const auto more = [&](size_t a, size_t b) {
    const float flat = out[b].at_mm - out[a].at_mm;
    return std::hypot(flat, kLayer * (out[b].thick - out[a].thick)) - flat;
  };
  const size_t middle = out.size() / 2;
  for (size_t k = middle; k > 0; --k) out[k - 1].more_mm = out[k].more_mm - more(k - 1, k);
  for (size_t k = middle; k + 1 < out.size(); ++k) out[k + 1].more_mm = out[k].more_mm + more(k, k + 1);
  return out;
}

void lay_strip(Pattern& pattern, const Piece& piece, const std::vector<Knot>& across, const std::vector<Knot>& along,
               const LayerGrid& grid, bool turned) {
  lay_on(
      pattern, piece, static_cast<int>(across.size()), static_cast<int>(along.size()),
      [&](int i, int j) {
        const Knot x = across[static_cast<size_t>(i)], y = along[static_cast<size_t>(j)];
        const Vec2 at = grid(x.at_mm, y.at_mm);
        return LaidAt{at[0], at[1], kLayer * std::fmin(x.thick, y.thick), {x.more_mm, y.more_mm}};
      },
      turned);
}

void lay_button(Pattern& pattern, const Piece& piece, Vec2 uv) {
  constexpr int kAcross = 9;
  constexpr float kRadius = 5.6f;
  // Of the rings from the middle outwards: how high, and how much longer its cloth is than its radius.
  constexpr std::array<float, 5> kHigh{1.7f, 1.7f, 1.9f, 2.3f, 0.2f}, kMore{0, 0, 0.01f, 0.07f, 1.2f};
  lay_on(pattern, piece, kAcross, kAcross, [&](int i, int j) {
    const Vec2 square{2 * share_of(i, kAcross) - 1, 2 * share_of(j, kAcross) - 1};
    // A square's rings made round: Shirley and Chiu's idea, by the larger of the two.
    const float ring = std::fmax(std::fabs(square[0]), std::fabs(square[1])), l = length(square);
    const Vec2 at = grid_at(pattern, piece, uv + (l > 0 ? square * (ring / l * kRadius) : square));
    const auto k = static_cast<size_t>(std::lround(4 * ring));
    return LaidAt{at[0], at[1], kLayer + kHigh[k], l > 0 ? square * (kMore[k] / l) : square};
  });
}

}  // namespace weftlight::drape
