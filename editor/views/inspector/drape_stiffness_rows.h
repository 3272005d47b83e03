#pragma once
// How the cloth hangs: limp or stiff, by which figures, and whether by its own or by those of its kind.

#include <string>

#include "views/common/names.h"
#include "views/common/panel.h"

namespace weftlight::views {

/// "Medium: bends over 19 mm, weighs 135 g/m²"; of a draft without threads empty.
std::string stiffness_in_words(const Design& design);
/// Nothing where the cloth lies flat, or over a mesh of the user's.
MaybeEdit draw_drape_stiffness(PanelContext& c);

}  // namespace weftlight::views
