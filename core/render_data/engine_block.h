#pragma once
// What an exported glTF set's material is made with, for rung `engine`.

#include "cloth/cloth.h"
#include "render_data/names.h"
#include "shaders/interop.h"

namespace weftlight::render_data {

/// Of one repeat of a face, as sets are: maps, answer and fit are made as for a set. About a tenth of a second.
/// weft_share: of the cover, as the rung's maps have it.
interop::EngineData engine_block(const Cloth& repeat, float weft_share);

}  // namespace weftlight::render_data
