#include "reference/fibre_plan.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "cloth/thread_texture.h"

namespace weftlight::reference {

using cloth::fibre_count, cloth::fibre_step_mm, cloth::stray_count;
using draft::System;

namespace {

constexpr float kMarginThicknesses = 3;
constexpr int kPiecesACrossing = 6;
// Bytes of a piece (its first point and its index), and of a fibre and of a stray one (their last point, what they are,
// their dye).
constexpr int64_t kPieceBytes = 20, kFibreBytes = 68, kStrayBytes = 92;
// What Embree's tree takes, measured with Embree 3.13: 32 bytes a piece in a buffer that doubles as it grows. From a
// million pieces on the tree is built in their place, below it stands beside them.
constexpr int64_t kReferenceBytes = 32, kNodeBytes = 26, kInPlace = 1'000'000, kTreeBytes = 3'500'000;
// Pieces of a mean stray fibre: seven loops for ten hairs.
constexpr double kStrayPieces = (10.0 * kHairPieces + 7.0 * kLoopPieces) / 17;

struct Extent {
  float low = 0, high = 0;
  bool repeats = false;
};

Extent extent_of(float low, float high, float margin, float period) {
  const float whole = std::max(std::ceil((high - low) / period - 1e-4f), 1.0f) * period;
  if (whole <= high - low + 2 * margin) return {0, whole, true};
  return {low - margin, high + margin, false};
}

FibreThread thread_of(const ThreadPaths& paths, System s, int thread, int64_t copy, const FibreOptions& options) {
  using cloth::thread_formulas::mix_bits;
  const ThreadBody& body = paths.threads(s)[static_cast<size_t>(thread)];
  FibreThread made;
  made.yarn = paths.cloth().yarns[static_cast<size_t>(body.yarn)];
  made.system = s;
  made.diameter_mm = body.diameter_mm > 0 ? body.diameter_mm : std::sqrt(body.width_mm * body.height_mm);
  made.raised = options.raised;
  const uint32_t own = static_cast<uint32_t>(copy * static_cast<int64_t>(paths.threads(s).size()) + thread);
  made.seed = mix_bits(mix_bits(own, s == System::kWarp ? 0x51u : 0xA7u), options.seed);
  return made;
}

/// Where copies r of all threads are, in the repeats of the patch: the same copy again after `copies` of them.
void list_threads(FibrePlan& plan, const ThreadPaths& paths, System s, const FibreOptions& options) {
  const int k = s == System::kWarp ? 0 : 1;
  const float low = plan.low[k], high = plan.high[k], period = paths.period_across(s), length = plan.length(s);
  const bool repeats = plan.repeats[k];
  const int64_t copies = repeats ? std::lround((high - low) / period) : 0;
  const auto first = static_cast<int64_t>(std::floor(low / period)) - 1,
             last = static_cast<int64_t>(std::floor(high / period)) + 1;
  const float others = static_cast<float>(paths.threads(s == System::kWarp ? System::kWeft : System::kWarp).size());
  const float crossing = paths.period_along(s) / others / kPiecesACrossing;
  for (int64_t r = first; r <= last; ++r)
    for (size_t i = 0; i < paths.threads(s).size(); ++i) {
      const ThreadBody& body = paths.threads(s)[i];
      if (!(body.width_mm > 0) || !(body.height_mm > 0)) continue;
      const float centre = body.centre_mm + static_cast<float>(r) * period,
                  reach = plan.cut ? 0 : paths.widest(s, static_cast<int>(i));
      const float outside = std::max(low - centre, centre - high);
      if (outside > reach + (repeats ? kHairReach_mm : 0)) continue;
      PlannedThread t;
      t.system = s, t.thread = static_cast<int>(i), t.centre_mm = centre, t.core = outside <= reach;
      t.made_for = thread_of(paths, s, t.thread, copies > 0 ? (r % copies + copies) % copies : r, options);
      t.made_for.length_mm = length, t.made_for.repeats = !plan.cut;
      const float step = std::min(crossing, fibre_step_mm(t.made_for.yarn));
      t.points = static_cast<int>(std::ceil((length + 2 * plan.pad_mm) / step)) + 1;
      plan.threads.push_back(std::move(t));
    }
}

void count(FibrePlan& plan) {
  FibreFigures& f = plan.figures;
  f.size_mm = plan.high - plan.low;
  for (const PlannedThread& t : plan.threads) {
    const int64_t fibres = t.core ? fibre_count(t.made_for) : 0, strays = stray_count(t.made_for);
    f.threads += t.core;
    f.fibres += fibres, f.strays += strays;
    f.curves += fibres * (t.points - 1) + std::llround(static_cast<double>(strays) * kStrayPieces);
  }
  f.bytes = bytes_of(f);
}

}  // namespace

int64_t bytes_of(const FibreFigures& f) {
  const auto references = static_cast<int64_t>(std::bit_ceil(static_cast<uint64_t>(kReferenceBytes * f.curves)));
  const int64_t tree = references + (f.curves < kInPlace ? kNodeBytes * f.curves : kTreeBytes);
  return tree + kPieceBytes * f.curves + kFibreBytes * f.fibres + kStrayBytes * f.strays;
}

FibrePlan plan_fibres(const ThreadPaths& paths, const FibreOptions& options) {
  FibrePlan plan;
  const float thickness = 2 * (paths.thickest(System::kWarp) + paths.thickest(System::kWeft));
  const float margin = kMarginThicknesses * thickness;
  const Extent u = extent_of(options.low_mm.x, options.high_mm.x, margin, paths.cloth().width_mm),
               v = extent_of(options.low_mm.y, options.high_mm.y, margin, paths.cloth().depth_mm);
  plan.low = {u.low, v.low}, plan.high = {u.high, v.high};
  plan.repeats[0] = u.repeats, plan.repeats[1] = v.repeats;
  plan.pad_mm = 0.5f * thickness;
  for (const System s : {System::kWarp, System::kWeft}) list_threads(plan, paths, s, options);
  count(plan);
  return plan;
}

FibrePlan plan_cut_patch(const ThreadPaths& paths, const FibreOptions& options) {
  FibrePlan plan;
  plan.cut = true;
  plan.low = options.low_mm, plan.high = options.high_mm;
  for (const System s : {System::kWarp, System::kWeft}) list_threads(plan, paths, s, options);
  count(plan);
  return plan;
}

FibreFigures fibre_figures(const Cloth& cloth, const FibreOptions& options) {
  return plan_fibres(ThreadPaths(cloth), options).figures;
}

}  // namespace weftlight::reference
