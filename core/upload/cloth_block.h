#pragma once
// The numbers of a cloth that the shaders read as uniforms (interop::ClothData).

#include <array>
#include <vector>

#include "cloth/maps.h"
#include "shaders/interop.h"
#include "upload/names.h"

namespace weftlight::upload {

/// `front` and `back` are the faces' cloths and maps.
struct FaceInput {
  const Cloth& cloth;
  const Maps& maps;
};
std::vector<float> cloth_block(const FaceInput& front, const FaceInput& back);

/// The first four of interop::SystemData, of one yarn.
std::array<interop::vec4, 4> yarn_numbers(const Lobes& lobes);

/// Mean spacing of the threads of both systems, mm.
float mean_spacing_mm(const Cloth& cloth);

}  // namespace weftlight::upload
