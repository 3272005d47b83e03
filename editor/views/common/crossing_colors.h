#pragma once
// The colours of a draft's threads where they cross, as ImGui packs them.

#include <vector>

#include "design/dye.h"
#include "views/common/panel.h"

namespace weftlight::views {

using draft::Draft, draft::System;

struct CrossingColors {
  std::vector<ImU32> warp, weft;  // of the threads that have one
  design::DyedThreads dyed;       // the others

  ImU32 of(System system, int thread, int crossing) const {
    const draft::Rgb* const color = dyed.color(system, thread, crossing);
    return color != nullptr ? to_u32(*color) : (system == System::kWarp ? warp : weft)[static_cast<size_t>(thread)];
  }
  bool operator==(const CrossingColors&) const = default;
};

/// The palette's colours of the threads of a system.
std::vector<ImU32> thread_colors(const Draft& draft, System system);

CrossingColors crossing_colors(const design::Design& design);
/// One colour for each system.
CrossingColors two_colors(const Draft& draft, ImU32 warp, ImU32 weft);

}  // namespace weftlight::views
