#pragma once
// Preview of a large edit: of many painted cells only the visible part of the front is baked, at the level of the
// picture's pixels, for the next frame. It goes to the renderer alone and changes no output of a stage, so the next
// full update starts from the state before.

#include "render_data/method_weights.h"
#include "render_data/stage_data.h"

namespace weftlight::render_data {

using design::Design;

/// Bakes the preview if `now` differs from `before`, which the renderer shows, only in its crossings, and these are too
/// many to wait for; `again`: the renderer shows a preview, which must be replaced however few they are. False: not
/// baked.
bool preview_visible(const StageData& data, const Design& before, const Design& now, const VisiblePart& visible,
                     bool again, StageResult& result);

}  // namespace weftlight::render_data
