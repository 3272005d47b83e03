#include "loom/tabby.h"

#include <algorithm>
#include <iterator>

namespace weftlight::loom {

using draft::ShedControl, draft::for_each_bit;

std::optional<TabbySheds> tabby_sheds(const Draft& draft) {
  std::vector<uint8_t> carries(static_cast<size_t>(draft.shafts), 0);  // bit 0: odd ends, bit 1: even ones
  for (int end = 0; end < draft.ends(); ++end)
    for_each_bit(draft.threading.row(end),
                 [&](int shaft) { carries[static_cast<size_t>(shaft)] |= end % 2 == 0 ? 1 : 2; });
  TabbySheds sheds;
  for (int shaft = 0; shaft < draft.shafts; ++shaft) {
    const uint8_t ends = carries[static_cast<size_t>(shaft)];
    if (ends == 3) return {};
    if (ends != 0) (ends == 1 ? sheds.first : sheds.second).push_back(shaft);
  }
  if (sheds.first.empty() || sheds.second.empty()) return {};
  return sheds;
}

std::vector<int> treadles_of_shed(const Draft& draft, const TabbySheds& sheds, bool second) {
  if (draft.shed_control != ShedControl::kTreadling) return {};
  constexpr int kMaxPaired = 64;  // treadles; more are not tried two by two
  // The tie-up names what rises, or what sinks: then the other shed.
  const std::vector<int>& named = second == draft.rising ? sheds.second : sheds.first;
  std::vector<uint8_t> used(static_cast<size_t>(draft.shafts), 0);
  for (const std::vector<int>* shed : {&sheds.first, &sheds.second})
    for (const int shaft : *shed) used[static_cast<size_t>(shaft)] = 1;
  const auto moved_by = [&](int treadle) {
    std::vector<int> shafts;
    for_each_bit(draft.tieup.row(treadle), [&](int shaft) {
      if (used[static_cast<size_t>(shaft)]) shafts.push_back(shaft);
    });
    return shafts;
  };
  std::vector<std::vector<int>> moved;
  for (int treadle = 0; treadle < draft.treadles; ++treadle) {
    moved.push_back(moved_by(treadle));
    if (moved.back() == named) return {treadle};
  }
  for (int a = 0; a < std::min(draft.treadles, kMaxPaired); ++a)
    for (int b = a + 1; b < std::min(draft.treadles, kMaxPaired); ++b) {
      std::vector<int> both;
      std::ranges::set_union(moved[static_cast<size_t>(a)], moved[static_cast<size_t>(b)], std::back_inserter(both));
      if (both == named) return {a, b};
    }
  return {};
}

}  // namespace weftlight::loom
