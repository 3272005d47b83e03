#pragma once
// Material of an exported glTF set, for method `engine`.

#include "cloth/cloth.h"
#include "shaders/interop.h"

namespace weftlight::render_data {

using cloth::Cloth;

/// From one repeat of a face, as sets are; takes about a tenth of a second. weft_fraction: of the coverage, as in the
/// maps of method `engine`.
interop::EngineData engine_block(const Cloth& repeat, float weft_fraction);

}  // namespace weftlight::render_data
