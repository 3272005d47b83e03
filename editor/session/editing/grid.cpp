#include "session/editing/grid.h"

namespace weftlight::session {

const char* grid_name(GridId grid) {
  constexpr const char* kNames[] = {"",         "threading", "tieup",       "treadling",
                                    "liftplan", "drawdown",  "warp_colors", "weft_colors"};
  return kNames[static_cast<int>(grid)];
}

bool has_ends(GridId grid) {
  return grid == GridId::kThreading || grid == GridId::kDrawdown || grid == GridId::kWarpColors;
}

bool has_picks(GridId grid) {
  return grid == GridId::kTreadling || grid == GridId::kLiftplan || grid == GridId::kDrawdown ||
         grid == GridId::kWeftColors;
}

}  // namespace weftlight::session
