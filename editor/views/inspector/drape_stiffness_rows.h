#pragma once
// The drape: generic or simulated, the stiffness of the cloth, and the progress of the simulation.

#include <string>

#include "session/jobs/draper.h"
#include "views/common/panel.h"

namespace weftlight::views {

using analysis::Units;
using design::Design;
using session::DrapeState, session::MaybeEdit;

/// "Medium: bending length 19 mm, 135 g/m²", or in inches and oz/yd². The weight is that of the planned cloth. Empty
/// for a draft without threads.
std::string stiffness_in_words(const Design& design, Units units);
/// Draws nothing if the cloth is flat or on the user's own mesh.
MaybeEdit draw_drape_stiffness(PanelContext& c, const DrapeState& drape);

}  // namespace weftlight::views
