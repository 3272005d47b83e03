#include "ui/damage.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <utility>

namespace weftlight::ui {
namespace {

float size_of(const Area& a) { return (a.x1 - a.x0) * (a.y1 - a.y0); }

Area joined(const Area& a, const Area& b) {
  return {std::min(a.x0, b.x0), std::min(a.y0, b.y0), std::max(a.x1, b.x1), std::max(a.y1, b.y1)};
}

/// Adds an area to the few that are kept: to one that grows by no more than what it takes in, or as one more.
void add(std::vector<Area>& areas, Area next) {
  if (next.empty()) return;
  constexpr float kFreeGrowth = 64 * 64;  // of so few pixels a join costs less than another pass over the window
  size_t best = areas.size();
  float least = std::numeric_limits<float>::max();
  for (size_t i = 0; i < areas.size(); ++i) {
    const float growth = size_of(joined(areas[i], next)) - size_of(areas[i]) - size_of(next);
    if (growth < least) least = growth, best = i;
  }
  if (best < areas.size() && (least <= kFreeGrowth || areas.size() == Damage::kMaxAreas))
    areas[best] = joined(areas[best], next);
  else areas.push_back(next);
}

/// A pixel more on every side, which the edges of smoothed lines may touch.
template <class Triangle>
Area area_of(const Triangle& t) {
  const auto [x0, x1] = std::minmax({t.corner[0].pos.x, t.corner[1].pos.x, t.corner[2].pos.x});
  const auto [y0, y1] = std::minmax({t.corner[0].pos.y, t.corner[1].pos.y, t.corner[2].pos.y});
  return {std::max(std::floor(x0) - 1, std::floor(t.clip.x)), std::max(std::floor(y0) - 1, std::floor(t.clip.y)),
          std::min(std::ceil(x1) + 1, std::ceil(t.clip.z)), std::min(std::ceil(y1) + 1, std::ceil(t.clip.w))};
}

template <class Triangle>
bool same(const Triangle& a, const Triangle& b) {
  return a.texture == b.texture && std::memcmp(a.corner, b.corner, sizeof a.corner) == 0 &&
         std::memcmp(&a.clip, &b.clip, sizeof a.clip) == 0;
}

}  // namespace

Damage::List Damage::list_of(const ImDrawList& from) {
  List list{from._OwnerName != nullptr ? from._OwnerName : "", {}};
  list.triangles.reserve(static_cast<size_t>(from.IdxBuffer.Size) / 3);
  for (const ImDrawCmd& cmd : from.CmdBuffer) {
    for (unsigned i = 0; i + 2 < cmd.ElemCount; i += 3) {
      Triangle& t = list.triangles.emplace_back();
      for (unsigned k = 0; k < 3; ++k)
        t.corner[k] =
            from.VtxBuffer[static_cast<int>(cmd.VtxOffset + from.IdxBuffer[static_cast<int>(cmd.IdxOffset + i + k)])];
      t.clip = cmd.ClipRect;
      t.texture = cmd.GetTexID();
    }
  }
  return list;
}

/// Triangle by triangle where there are as many; else all between what both begin with and what both end with.
void Damage::compare(const List& before, const List& now, std::vector<Area>& areas) {
  const std::vector<Triangle>&a = before.triangles, &b = now.triangles;
  if (a.size() == b.size()) {
    for (size_t i = 0; i < a.size(); ++i) {
      if (!same(a[i], b[i])) add(areas, joined(area_of(a[i]), area_of(b[i])));
    }
    return;
  }
  const size_t shorter = std::min(a.size(), b.size());
  size_t head = 0, tail = 0;
  while (head < shorter && same(a[head], b[head])) ++head;
  while (tail < shorter - head && same(a[a.size() - 1 - tail], b[b.size() - 1 - tail])) ++tail;
  for (size_t i = head; i < a.size() - tail; ++i) add(areas, area_of(a[i]));
  for (size_t i = head; i < b.size() - tail; ++i) add(areas, area_of(b[i]));
}

std::vector<Area> Damage::of(const ImDrawData& data) {
  std::vector<List> now;
  for (int i = 0; i < data.CmdListsCount; ++i) now.push_back(list_of(*data.CmdLists[i]));
  const Area all{data.DisplayPos.x, data.DisplayPos.y, data.DisplayPos.x + data.DisplaySize.x,
                 data.DisplayPos.y + data.DisplaySize.y};
  std::vector<Area> areas;
  const auto owner = [](const List& a, const List& b) { return a.owner == b.owner; };
  const bool resized = data.DisplaySize.x != size_.x || data.DisplaySize.y != size_.y;
  // What lies over what may have changed as well: windows that come, go or change places are rare.
  if (std::exchange(whole_, false) || resized ||
      !std::equal(before_.begin(), before_.end(), now.begin(), now.end(), owner)) {
    areas = {all};
  } else {
    for (size_t i = 0; i < now.size(); ++i) compare(before_[i], now[i], areas);
  }
  before_ = std::move(now);
  size_ = data.DisplaySize;
  return areas;
}

}  // namespace weftlight::ui
