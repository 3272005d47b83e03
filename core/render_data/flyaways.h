#pragma once
// Roots of the flyaway fibres that are visible against the background: along silhouettes, edges of folds and hems.
// They depend on the view; the same view gives the same fibres.

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "draft/drawdown.h"
#include "render_data/ambient.h"
#include "shaders/interop.h"

namespace weftlight::render_data {

using draft::Face;
using drape::Mesh;

/// Flyaway fibres on the front (0) and back (1) of the mesh.
struct FlyawayGrowth {
  std::array<float, 2> per_mm2{};    // 0: none
  std::array<float, 2> length_mm{};  // mean
  float hem_mm = 0;                  // radius of the cloth's edge
  bool operator==(const FlyawayGrowth&) const = default;
};

/// From the fuzz of the visible yarns: a filament weft on a wool warp halves the fibres. `front`: the face of the
/// cloth on the mesh's front.
FlyawayGrowth flyaway_growth(const interop::ClothData& cloth, Face front);

struct FlyawayView {
  glm::mat4 world_to_clip{1};
  glm::vec3 eye{0};
  float width = 0, height = 0;  // pixels
  bool operator==(const FlyawayView&) const = default;
};

/// A boundary edge of the cloth.
struct Hem {
  uint32_t from = 0, to = 0;  // vertices
  glm::vec3 outward{0};       // unit, in the plane of the cloth, across the edge
};
std::vector<Hem> hems_of(const Mesh& mesh, const std::vector<uint32_t>& index);

/// A root, in the layout of flyaway.vert.
struct Flyaway {
  glm::vec3 root{0}, normal{0};  // normal: of the cloth on the fibre's side
  glm::vec2 uv_mm{0};            // from uv_origin_mm
  float sky = 1, side = 1;       // side: +1 the mesh's front, -1 its back
  float seed = 0;                // 0..1
  float stands_for =
      1;  // number of fibres; more than one where they cannot be told apart, less where short ones fade out
  float least_mm = 0;   // shorter fibres do not reach past the silhouette
  float radius_mm = 0;  // radius of curvature at the silhouette
};

/// Roots on the triangles of prepared.fine, at most about kMaxFlyaways: beyond, each stands for more fibres, so that
/// the total coverage stays.
inline constexpr float kMaxFlyaways = 100000;
std::vector<Flyaway> scatter_flyaways(const PreparedMesh& prepared, const std::vector<Hem>& hems,
                                      std::array<double, 2> uv_origin_mm, const FlyawayGrowth& growth,
                                      const FlyawayView& view);

}  // namespace weftlight::render_data
