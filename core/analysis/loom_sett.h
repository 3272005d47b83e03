#pragma once
// The sett of a new draft: firm on the loom, in whole threads as weavers say it.

#include "analysis/units.h"
#include "design/design.h"

namespace weftlight::analysis {

using design::Design;

/// Threads in a cm of the loom, or in an inch.
struct LoomSett {
  int ends = 1, picks = 1;
  bool operator==(const LoomSett&) const = default;
};

/// The firm sett (threads.h) of ends and picks, rounded. Of a large draft its first 1024 ends and picks count. What no
/// thread binds keeps the sett that it has.
LoomSett firm_sett(const Design& design, Units units);
/// The draft drawn at the sett that the finished cloth has by its plan if it is woven at this one.
Design with_loom_sett(Design design, LoomSett sett, Units units);

}  // namespace weftlight::analysis
