#pragma once
// The draped mesh as a ray-tracing scene: intersections with the cloth, and the cloth's frame there. World space, mm.

#include <glm/glm.hpp>
#include <limits>
#include <memory>

#include "base/result.h"
#include "drape/mesh.h"

namespace weftlight::reference {

using drape::Mesh;

struct MeshHit {
  float t = 0;
  glm::vec3 position;
  glm::vec2 uv_mm;
  glm::vec3 weft, warp, normal;  // orthonormal: along u, along v, out of the front face
  bool front = true;             // the ray hit the side of the normals
  uint32_t triangle = 0;
};

class MeshScene {
 public:
  static constexpr float kEndless = std::numeric_limits<float>::infinity();
  static base::Result<std::unique_ptr<MeshScene>> build(const Mesh& mesh);
  ~MeshScene();
  MeshScene(const MeshScene&) = delete;
  MeshScene& operator=(const MeshScene&) = delete;

  bool intersect(glm::vec3 origin, glm::vec3 direction, float t_min, MeshHit& hit) const;
  /// Whether the ray hits the mesh between t_min and t_max.
  bool occluded(glm::vec3 origin, glm::vec3 direction, float t_min, float t_max = kEndless) const;

 private:
  MeshScene();
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace weftlight::reference
