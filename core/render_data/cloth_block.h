#pragma once
// The parameters of a cloth that the shaders read as uniforms (interop::ClothData).

#include "cloth/maps.h"
#include "shaders/interop.h"

namespace weftlight::render_data {

using cloth::Cloth, cloth::Maps;

struct FaceInput {
  const Cloth& cloth;
  const Maps& maps;
};

/// Everything except what response_tables() sets: fractions, facets, sky, and the final colours.
interop::ClothData cloth_block(const FaceInput& front, const FaceInput& back);

/// Mean spacing of the threads of both systems, mm.
float mean_spacing_mm(const Cloth& cloth);

}  // namespace weftlight::render_data
