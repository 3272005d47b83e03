#include "views/common/crossing_colors.h"

namespace weftlight::views {

std::vector<ImU32> thread_colors(const Draft& draft, System system) {
  std::vector<ImU32> out;
  for (const int color : draft.threads(system).color) out.push_back(to_u32(draft.palette[static_cast<size_t>(color)]));
  return out;
}

CrossingColors crossing_colors(const design::Design& design) {
  return {thread_colors(design.draft, System::kWarp), thread_colors(design.draft, System::kWeft),
          design::DyedThreads(design)};
}

CrossingColors two_colors(const Draft& draft, ImU32 warp, ImU32 weft) {
  return {std::vector<ImU32>(static_cast<size_t>(draft.ends()), warp),
          std::vector<ImU32>(static_cast<size_t>(draft.picks()), weft),
          {}};
}

}  // namespace weftlight::views
