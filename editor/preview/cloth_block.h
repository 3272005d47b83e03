#pragma once
// The numbers of a cloth that the shaders read as uniforms (interop::ClothData).

#include <vector>

#include "cloth/maps.h"
#include "shaders/interop.h"

namespace weftlight {

/// `front` and `back` are the faces' cloths and maps.
struct FaceInput {
  const Cloth& cloth;
  const Maps& maps;
};
/// `height_bound_mm` is that of the packed heights.
std::vector<float> cloth_block(const FaceInput& front, const FaceInput& back, float height_bound_mm);

/// Mean spacing of the threads of both systems, mm.
float mean_spacing_mm(const Cloth& cloth);

}  // namespace weftlight
