#pragma once
// The stages from the draft to the packed maps of both faces (stages.cpp has the list).

#include "render_data/stage_data.h"

namespace weftlight::render_data {

using draft::Face;

/// Draft -> drawdown. A painted cell changes a part of it.
base::Result<Outcome> update_cells(StageWork& work, Change input);
/// Drawdown, threads -> the period that is drawn.
base::Result<Outcome> update_period(StageWork& work, Change input);
/// Drawdown, period, threads, yarns -> the cloth of a face.
base::Result<Outcome> update_threads(StageWork& work, Change input, Face face);
/// Cloth -> its maps; after painted cells, only the rectangles around these.
base::Result<Outcome> update_maps(StageWork& work, Change input, Face face);
/// Maps -> packed texels with their mips.
base::Result<Outcome> update_mips(StageWork& work, Change input, Face face);
/// Cloth of both faces -> the factors of its BRDF, for method vrst03.
base::Result<Outcome> update_cube_maps(StageWork& work, Change input);
/// Cloth of the front -> its crossings; the back has the same, turned over.
base::Result<Outcome> update_crossings(StageWork& work, Change input);

}  // namespace weftlight::render_data
