#pragma once
// Where stray fibres stand that the eye can see against what is behind the cloth: along its silhouettes, the
// rims of its folds and its hems. Which ones depends on the view; the same view gives the same fibres.

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "draft/drawdown.h"
#include "render_data/ambient.h"
#include "render_data/names.h"
#include "shaders/interop.h"

namespace weftlight::render_data {

/// The fibres of the mesh's front (0) and back (1).
struct FlyawayGrowth {
  std::array<float, 2> per_mm2{};    // 0: none
  std::array<float, 2> length_mm{};  // mean
  float hem_mm = 0;                  // radius of the cloth's edge
  bool operator==(const FlyawayGrowth&) const = default;
};

/// By the fuzz of the yarns that show, so that a filament weft on a wool warp halves the fibres. `front`: the
/// face of the cloth that the mesh's front shows.
FlyawayGrowth flyaway_growth(const interop::ClothData& cloth, Face front);

struct FlyawayView {
  glm::mat4 world_to_clip{1};
  glm::vec3 eye{0};
  float width = 0, height = 0;  // pixels
  bool operator==(const FlyawayView&) const = default;
};

/// An edge of the cloth, with no triangle beyond it.
struct Hem {
  uint32_t from = 0, to = 0;  // vertices
  glm::vec3 outward{0};       // unit, in the cloth, across the edge
};
std::vector<Hem> hems_of(const Mesh& mesh, const std::vector<uint32_t>& index);

/// A root, as flyaway.vert takes it.
struct Flyaway {
  glm::vec3 root{0}, normal{0};  // normal: of the cloth on the fibre's side
  glm::vec2 uv_mm{0};            // from uv_origin_mm
  float sky = 1, side = 1;       // side: +1 the mesh's front, -1 its back
  float seed = 0;                // 0..1
  float stands_for = 1;          // fibres; more than one where they are finer than can be told apart
  float least_mm = 0;            // shorter ones do not reach past the edge
  float radius_mm = 0;           // of the rim
};

/// Roots on the triangles of prepared.fine. At most about kMaxFlyaways: where there would be more, each stands
/// for more, so that what they cover stays the same.
inline constexpr float kMaxFlyaways = 100000;
std::vector<Flyaway> sow_hairs(const PreparedMesh& prepared, const std::vector<Hem>& hems,
                               std::array<double, 2> uv_origin_mm, const FlyawayGrowth& growth,
                               const FlyawayView& view);

}  // namespace weftlight::render_data
