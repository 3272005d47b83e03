#pragma once
// The yarns of the design: the list, and the properties and optics of the active one.

#include <string>

#include "design/yarn_fields.h"
#include "session/editing/drawing_state.h"
#include "views/common/panel.h"
#include "views/common/yarn_strip.h"

namespace weftlight::views {

using session::DrawingState, session::MaybeEdit;

/// The figure of a field with its unit, for printf: "%.0f %%".
std::string figure_format(const design::FieldFacts& field);
MaybeEdit draw_yarns(const PanelContext& c, const DrawingState& drawing, YarnStrip& strip);

}  // namespace weftlight::views
