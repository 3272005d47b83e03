#pragma once
// The ready yarns by name, and designs woven in them.

#include <algorithm>
#include <string_view>
#include <utility>

#include "design/design.h"
#include "design/yarn_presets.h"

namespace weftlight {

using design::clamped;

/// The first where there is none of that name.
inline const design::Yarn& yarn_preset(std::string_view name) {
  const auto all = design::ready_yarns();
  const auto at = std::ranges::find(all, name, &design::Yarn::name);
  return at != all.end() ? *at : all.front();
}

/// One yarn for the whole warp, one for the whole weft.
inline design::Design with_yarns(design::Design design, const design::Yarn& warp, const design::Yarn& weft) {
  design.yarns = {clamped(warp)};
  if (!(clamped(weft) == design.yarns[0])) design.yarns.push_back(clamped(weft));
  std::ranges::fill(design.draft.warp.yarn, 0);
  std::ranges::fill(design.draft.weft.yarn, static_cast<int>(design.yarns.size()) - 1);
  return design;
}

}  // namespace weftlight
