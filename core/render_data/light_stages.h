#pragma once
// The stages from cloth and yarns to the light that the cloth sends back: uniform blocks and tables (stages.cpp has the
// list).

#include "render_data/stage_data.h"

namespace weftlight::render_data {

/// Yarns -> their lobes in the cloth of both faces; layout and maps do not depend on them.
base::Result<Outcome> update_lobes(StageWork& work, Change input);
/// Cloth and maps of both faces -> uniform block. Means of the response are kept.
base::Result<Outcome> update_cloth_block(StageWork& work, Change input);
/// Cloth and maps of both faces -> tables of the far-field response, and its means in the block.
base::Result<Outcome> update_response(StageWork& work, Change input);
/// Cloth of the front -> errors of method `yarn`.
base::Result<Outcome> update_thread_errors(StageWork& work, Change input);
/// Design and block -> the exported material in the block, for method `engine`.
base::Result<Outcome> update_engine_block(StageWork& work, Change input);
/// Cloth of the front -> records of its threads.
base::Result<Outcome> update_thread_records(StageWork& work, Change input);
/// All of the above, handed over.
base::Result<Outcome> hand_over_lobes(StageWork& work, Change input);

}  // namespace weftlight::render_data
