#include "cloth/relief.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "base/loops.h"
#include "cloth/bake_parts.h"

namespace weftlight::cloth {

using base::for_each_job;

namespace {

constexpr int kCounted = 7;  // crossings of a float beside the one that is looked at; longer ones count as these
// Nothing is left of what repeats every 2 or 4 threads, so that baskets and ribs stay flat, too.
constexpr std::array kSmooth{1, 2, 2, 2, 1};
constexpr int kSmoothReach = 2, kSmoothSum = 8;
static_assert(kCounted + kSmoothReach == kReliefReach);
// Rise over the threads' spacing for each crossing that the floats of one face are longer by, at a usual shrinkage.
constexpr float kRiseACrossing = 0.5f, kUsualShrinkage = 0.08f;

/// The cells as bytes with a margin on all sides, wrapped.
struct PaddedCells {
  int cols;
  std::vector<uint8_t> up;
  explicit PaddedCells(const BitMatrix& bits) : cols(bits.cols() + 2 * kCounted) {
    up.resize(static_cast<size_t>(cols) * static_cast<size_t>(bits.rows() + 2 * kCounted));
    for_each_job(bits.rows() + 2 * kCounted, [&](int r) {
      uint8_t* out = &up[static_cast<size_t>(r) * static_cast<size_t>(cols)];
      const auto row = bits.row(wrap(r - kCounted, bits.rows()));
      for (int c = 0; c < cols; ++c) {
        const int e = wrap(c - kCounted, bits.cols());
        out[c] = (row[static_cast<size_t>(e >> 6)] >> (e & 63)) & 1u;
      }
    });
  }
  const uint8_t* at(int pick, int end) const {
    return &up[static_cast<size_t>(pick + kCounted) * static_cast<size_t>(cols) + static_cast<size_t>(end + kCounted)];
  }
};

/// Crossings of a float in one direction, itself not counted.
int run(const uint8_t* at, std::ptrdiff_t stride) {
  int n = 0;
  while (n < kCounted && at[stride * (n + 1)] == at[0]) ++n;
  return n;
}

/// By how many crossings the float on the face is longer than the one behind it.
int8_t longer_on_face(const uint8_t* at, std::ptrdiff_t row) {
  const int warp = std::min(run(at, -row) + run(at, row), kCounted),
            weft = std::min(run(at, -1) + run(at, 1), kCounted);
  return static_cast<int8_t>(at[0] ? warp - weft : weft - warp);
}

}  // namespace

std::vector<float> washed_relief(const Cloth& cloth, float washed, float shrinkage) {
  const int ends = cloth.up.cols(), picks = cloth.up.rows();
  const float rise =
      kRiseACrossing * std::clamp(washed, 0.0f, 1.0f) *
      std::sqrt(std::max(shrinkage, 0.0f) / kUsualShrinkage);  // as a bent float is longer than its chord
  if (!(rise > 0) || !cloth.layers.empty() || ends == 0 || picks == 0 || int64_t{ends} * picks > kMaxReliefCrossings)
    return {};
  const size_t width = static_cast<size_t>(ends);
  std::vector<int8_t> longer(width * static_cast<size_t>(picks));
  {
    const PaddedCells cells(cloth.up);
    for_each_job(picks, [&](int p) {
      for (int e = 0; e < ends; ++e)
        longer[static_cast<size_t>(p) * width + static_cast<size_t>(e)] = longer_on_face(cells.at(p, e), cells.cols);
    });
  }
  if (std::ranges::all_of(longer, [](int8_t n) { return n == 0; })) return {};
  std::vector<int16_t> across(longer.size());
  for_each_job(picks, [&](int p) {
    const int8_t* from = &longer[static_cast<size_t>(p) * width];
    for (int e = 0; e < ends; ++e) {
      int sum = 0;
      for (int k = -kSmoothReach; k <= kSmoothReach; ++k)
        sum += kSmooth[static_cast<size_t>(k + kSmoothReach)] * from[wrap(e + k, ends)];
      across[static_cast<size_t>(p) * width + static_cast<size_t>(e)] = static_cast<int16_t>(sum);
    }
  });
  const float spacing = 0.5f * (cloth.width_mm / static_cast<float>(ends) + cloth.depth_mm / static_cast<float>(picks));
  const float scale = rise * spacing / (kSmoothSum * kSmoothSum);
  std::vector<float> out(longer.size());
  for_each_job(picks, [&](int p) {
    for (int e = 0; e < ends; ++e) {
      int sum = 0;
      for (int k = -kSmoothReach; k <= kSmoothReach; ++k)
        sum += kSmooth[static_cast<size_t>(k + kSmoothReach)] *
               across[static_cast<size_t>(wrap(p + k, picks)) * width + static_cast<size_t>(e)];
      out[static_cast<size_t>(p) * width + static_cast<size_t>(e)] = scale * static_cast<float>(sum);
    }
  });
  if (std::ranges::all_of(out, [](float mm) { return mm == 0; })) return {};
  return out;
}

}  // namespace weftlight::cloth
