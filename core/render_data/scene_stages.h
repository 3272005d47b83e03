#pragma once
// The stages of the scene around the cloth (stages.cpp has the list). If a file cannot be read, the renderer keeps what
// it has.

#include "render_data/stage_data.h"

namespace weftlight::render_data {

/// Drape -> mesh with its sky visibility.
base::Result<Outcome> update_mesh(StageWork& work, Change input);
/// Name of the lighting -> lights.
base::Result<Outcome> update_lights(StageWork& work, Change input);

}  // namespace weftlight::render_data
