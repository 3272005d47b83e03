#pragma once
// A BRDF as a product of two cube maps, as VRST 2003 renders it; kept for comparison.
// Based on: Kautz, McCool 1999, "Interactive rendering with arbitrary BRDFs using separable approximations".

#include <array>
#include <vector>

#include "light/cloth_brdf.h"

namespace weftlight::light {

/// Faces +x -x +y -y +z -z in OpenGL's order and orientation, rows first.
struct CubeMap {
  int size = 0;
  std::array<std::vector<glm::vec3>, 6> faces;
};

/// Direction of the centre of a texel (not normalised, valid outside the face).
glm::vec3 cube_direction(int face, float x, float y, int size);
/// Bilinear within a face.
glm::vec3 sample(const CubeMap& map, const glm::vec3& direction);

enum class Split {
  kHalfDifference,  // first: half vector, second: formulas::vrst03_difference
  kRaw,             // first: wi, second: wo
};

struct Separable {
  Split split = Split::kHalfDifference;
  CubeMap first, second;
  float error = 0;  // relative RMS over all pairs of directions of the texels
};

/// Least-squares product over all pairs with both directions above the horizon; other pairs have no weight. size:
/// texels along a face's edge, 4..64.
Separable factorise(const ClothBrdf& brdf, Split split, int size = 16, int threads = 0);

/// BRDF from the cube maps; 0 below the horizon.
glm::vec3 evaluate(const Separable& separable, const glm::vec3& wi, const glm::vec3& wo);

}  // namespace weftlight::light
