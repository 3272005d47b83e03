#pragma once
// Plain weave with equal ends and picks, for the tests of surface samples.

#include <algorithm>

#include "cloth/cloth.h"
#include "draft/draft.h"
#include "draft/drawdown.h"

namespace weftlight::light {

using cloth::Cloth, cloth::Period, cloth::lay_out;
using design::Design, design::Yarn;
using draft::Draft, draft::Face, draft::ShedControl, draft::Threads, draft::blank_draft, draft::drawdown;

inline Cloth plain_cloth(int threads, float spacing_mm, float thickness_mm, const Yarn& yarn = {}) {
  Design design;
  design.draft = blank_draft(threads, threads, 2, 2);
  design.yarns[0] = yarn;
  Draft& d = design.draft;
  d.shed_control = ShedControl::kLiftplan;
  for (int i = 0; i < threads; ++i) {
    d.threading.set(i, i % 2, true);
    d.liftplan.set(i, i % 2, true);
  }
  for (Threads* system : {&d.warp, &d.weft}) {
    std::fill(system->spacing_mm.begin(), system->spacing_mm.end(), spacing_mm);
    std::fill(system->thickness_mm.begin(), system->thickness_mm.end(), thickness_mm);
  }
  return lay_out(design, drawdown(d), Face::kFront, Period::kWholeDraft);
}

}  // namespace weftlight::light
