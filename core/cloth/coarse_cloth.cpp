#include "cloth/coarse_cloth.h"

#include <algorithm>

namespace weftlight::cloth {

using draft::BitMatrix;

namespace {

/// The thread that represents each group. Its position within the group follows the golden ratio: at equal distances
/// all would be the same thread of a weave that repeats as often.
std::vector<int> chosen(int count, int group) {
  constexpr double kGolden = 0.6180339887498949;
  std::vector<int> out;
  double turn = 0.5;
  for (int first = 0; first < count; first += group) {
    const int of = std::min(group, count - first);
    out.push_back(first + std::min(of - 1, static_cast<int>(turn * of)));
    turn += kGolden;
    if (turn >= 1) turn -= 1;
  }
  return out;
}

std::vector<ThreadBody> widened(const std::vector<ThreadBody>& threads, const std::vector<int>& kept, int group) {
  std::vector<ThreadBody> out;
  out.reserve(kept.size());
  for (size_t i = 0; i < kept.size(); ++i) {
    const auto first = threads.begin() + static_cast<std::ptrdiff_t>(i) * group;
    const auto last = first + std::min<std::ptrdiff_t>(group, threads.end() - first) - 1;
    const float from = first->centre_mm - 0.5f * first->spacing_mm, to = last->centre_mm + 0.5f * last->spacing_mm;
    ThreadBody body = threads[static_cast<size_t>(kept[i])];
    if (room_mm(body) > 0) body.width_mm *= (to - from) / room_mm(body);
    body.before = body.after = {};
    body.centre_mm = 0.5f * (from + to), body.spacing_mm = to - from;
    out.push_back(body);
  }
  return out;
}

}  // namespace

Cloth coarse_cloth(const Cloth& cloth, int ends_a_thread, int picks_a_thread) {
  const int a = std::max(1, ends_a_thread), b = std::max(1, picks_a_thread);
  if ((a == 1 && b == 1) || !cloth.layers.empty() || cloth.ends.empty() || cloth.picks.empty()) return cloth;
  const std::vector<int> ends = chosen(static_cast<int>(cloth.ends.size()), a),
                         picks = chosen(static_cast<int>(cloth.picks.size()), b);
  Cloth out;
  out.width_mm = cloth.width_mm, out.depth_mm = cloth.depth_mm;
  out.yarns = cloth.yarns, out.dyes = cloth.dyes;
  out.ends = widened(cloth.ends, ends, a), out.picks = widened(cloth.picks, picks, b);
  out.up = BitMatrix(static_cast<int>(picks.size()), static_cast<int>(ends.size()));
  for (int p = 0; p < out.up.rows(); ++p) {
    for (int e = 0; e < out.up.cols(); ++e) {
      const int pick = picks[static_cast<size_t>(p)], end = ends[static_cast<size_t>(e)];
      if (cloth.up.get(pick, end)) out.up.set(p, e, true);
      if (cloth.warp_level_mm.empty()) continue;
      const size_t at = static_cast<size_t>(pick) * static_cast<size_t>(cloth.up.cols()) + static_cast<size_t>(end);
      out.warp_level_mm.push_back(cloth.warp_level_mm[at]);
    }
  }
  out.weft_level_mm = out.warp_level_mm;
  return out;
}

}  // namespace weftlight::cloth
