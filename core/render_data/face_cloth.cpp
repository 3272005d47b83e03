#include "render_data/face_cloth.h"

#include <algorithm>
#include <cmath>

#include "cloth/coarse_cloth.h"
#include "design/repeat.h"

namespace weftlight::render_data {

using cloth::ThreadBody, cloth::bake, cloth::coarse_cloth, cloth::lay_out;
using design::Repeat, design::Twist, design::Yarn, design::design_repeat;

namespace {

constexpr int kAzimuths = 16;
constexpr int kFewAzimuths = 4;                 // of a map with about one texel a thread: it is nearly flat
constexpr double kFinePerHorizon = 3;           // texels across a thread from which on threads shade each other
constexpr double kTexels = 1024.0 * 1024.0;     // of one face, if that gives each thread enough
constexpr double kMaxTexels = 2048.0 * 2048.0;  // for drafts of many threads
constexpr double kMinPerThread = 6;             // texels across a thread that are worth more than kTexels
constexpr double kMaxPerThread = 64;            // beyond, fibres are smooth
constexpr double kFinePerThread = 14;           // a coarser whole draft is replaced by its repeat
constexpr double kUnevenPerThread = 5;          // the same, where no two threads are alike
constexpr int kLongest = 8192;
constexpr int kQuickShrink = 4;        // divisor of a quick bake's sides
constexpr double kQuickThreads = 1.7;  // threads across a texel of it; beyond, some represent all
constexpr int kQuickThreadSamples = 1;

bool same_bodies(const std::vector<ThreadBody>& a, const std::vector<ThreadBody>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const ThreadBody& s, const ThreadBody& t) {
    return s.centre_mm == t.centre_mm && s.spacing_mm == t.spacing_mm && s.width_mm == t.width_mm &&
           s.height_mm == t.height_mm && s.before == t.before && s.after == t.after && s.yarn == t.yarn &&
           s.colour == t.colour && s.dye == t.dye && s.dye_phase == t.dye_phase;
  });
}

int power_of_two(double v) {
  const double floor2 = std::exp2(std::floor(std::log2(std::max(1.0, v)) + 0.5));
  return static_cast<int>(std::min<double>(kLongest, floor2));
}

/// Texels across one thread within the budget.
double per_thread(double crossings) {
  const double wanted = std::sqrt(kTexels / std::max(1.0, crossings));
  if (wanted >= kMinPerThread) return std::min(wanted, kMaxPerThread);
  return std::min(kMinPerThread, std::sqrt(kMaxTexels / std::max(1.0, crossings)));
}

}  // namespace

Cloth face_cloth(const Design& design, const BitMatrix& cells, Face face, Period period) {
  Cloth cloth = lay_out(design, cells, face, period);
  if (face == Face::kBack) {
    for (Yarn& yarn : cloth.yarns) {
      yarn.twist = yarn.twist == Twist::kS ? Twist::kZ : yarn.twist == Twist::kZ ? Twist::kS : Twist::kNone;
    }
  }
  return cloth;
}

bool is_uneven(const Design& design) {
  // Less is hardly visible, and a repeat shows everything else more sharply.
  constexpr float kBetween = 0.03f, kAlong = 15;
  return std::ranges::any_of(design.yarns,
                             [](const Yarn& y) { return y.irregularity >= kBetween || y.unevenness >= kAlong; });
}

Period choose_period(const Design& design, const BitMatrix& cells) {
  const double whole = per_thread(static_cast<double>(cells.cols()) * cells.rows());
  if (whole >= (is_uneven(design) ? kUnevenPerThread : kFinePerThread)) return Period::kWholeDraft;
  const Repeat size = design_repeat(design, cells);
  const double repeat = per_thread(static_cast<double>(size.ends) * size.picks);
  return repeat > 1.5 * whole ? Period::kRepeat : Period::kWholeDraft;
}

bool same_layout(const Cloth& a, const Cloth& b) {
  return a.width_mm == b.width_mm && a.depth_mm == b.depth_mm && same_bodies(a.ends, b.ends) &&
         same_bodies(a.picks, b.picks) && a.dyes == b.dyes && a.layers.empty() && b.layers.empty() &&
         a.warp_aside_mm.empty() == b.warp_aside_mm.empty();
}

MapsSize maps_size(const Cloth& cloth, bool shadows) {
  const double ends = static_cast<double>(cloth.ends.size()), picks = static_cast<double>(cloth.picks.size());
  // Shadow maps take more memory than all other maps together: with them a large draft keeps to the smaller budget.
  const double fewer =
      shadows ? std::min(1.0, std::sqrt(kTexels / std::max(1.0, ends * picks)) / per_thread(ends * picks)) : 1.0;
  const double n = per_thread(ends * picks) * fewer;
  // The number of texels follows the number of threads.
  MapsSize size{power_of_two(ends * n), power_of_two(picks * n), n < kFinePerHorizon ? kFewAzimuths : kAzimuths};
  return size;
}

MapsSize quick_maps_size(const Cloth& cloth, bool shadows) {
  MapsSize size = maps_size(cloth, shadows);
  size.width = std::max(1, size.width / kQuickShrink), size.height = std::max(1, size.height / kQuickShrink);
  return size;
}

Maps bake_quick(const Cloth& cloth, const MapsSize& size, const TexelRect& window) {
  const auto group = [](size_t threads, int texels) {
    return std::max(1, static_cast<int>(std::lround(static_cast<double>(threads) / texels / kQuickThreads)));
  };
  const int ends = group(cloth.ends.size(), size.width), picks = group(cloth.picks.size(), size.height);
  MapsSize fewer = size;
  fewer.samples_a_thread = kQuickThreadSamples;
  if (ends * picks == 1) return bake(cloth, fewer, window);
  return bake(coarse_cloth(cloth, ends, picks), fewer, window);
}

}  // namespace weftlight::render_data
