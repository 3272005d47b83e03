#pragma once
// The numbers of a cloth that the shaders read as uniforms (interop::ClothData).

#include "cloth/maps.h"
#include "render_data/names.h"
#include "shaders/interop.h"

namespace weftlight::render_data {

/// A face's cloth and maps.
struct FaceInput {
  const Cloth& cloth;
  const Maps& maps;
};

/// All but what response_block.h measures: there shares, facets and sky are set, and the colours again.
interop::ClothData cloth_block(const FaceInput& front, const FaceInput& back);

/// Mean spacing of the threads of both systems, mm.
float mean_spacing_mm(const Cloth& cloth);

}  // namespace weftlight::render_data
