#include "views/common/panel.h"

#include <imgui.h>

namespace weftlight::views {

using analysis::Units;

Units units_of(const Settings& settings) { return settings.imperial ? Units::kImperial : Units::kMetric; }

ImU32 to_u32(Rgb c, float alpha) { return ImGui::ColorConvertFloat4ToU32(ImVec4(c.r, c.g, c.b, alpha)); }

}  // namespace weftlight::views
