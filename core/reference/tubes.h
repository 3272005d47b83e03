#pragma once
// The threads of one period as solid tubes: sections swept along the centre lines of core/cloth, infinite in
// both directions. Rays are in cloth space: x along the weft (u), y along the warp (v), z out of the face,
// millimetres.

#include <glm/glm.hpp>
#include <memory>
#include <string>

#include "base/result.h"
#include "cloth/cloth.h"

namespace weftlight::reference {

using cloth::Cloth;
using draft::System;

struct TubeOptions {
  int around = 48;                     // facets of a section
  int per_crossing = 20;               // rings for each thread crossed
  int64_t max_triangles = 12'000'000;  // about 1.5 GB; the resolution is reduced to stay below, down to 8 x 4
};

struct TubeHit {
  float t = 0;             // distance along the ray, mm
  glm::vec3 position;      // in the infinite cloth (not wrapped)
  glm::vec3 normal, axis;  // normal of the section; unit direction of the centre line
  System system = System::kWarp;
  int thread = 0;
  float along_mm = 0;    // on the centre line, within the period
  float around_rad = 0;  // on the section: 0 towards +across, pi / 2 up
};

class TubeScene {
 public:
  /// An error if the period has too many crossings for the triangle budget.
  static base::Result<std::unique_ptr<TubeScene>> build(const Cloth& cloth, const TubeOptions& options);
  ~TubeScene();
  TubeScene(const TubeScene&) = delete;
  TubeScene& operator=(const TubeScene&) = delete;

  /// Closest tube along the ray from t_min on. False: the ray leaves the cloth.
  bool intersect(glm::vec3 origin, glm::vec3 direction, float t_min, TubeHit& hit) const;
  bool occluded(glm::vec3 origin, glm::vec3 direction, float t_min) const;
  /// All tubes lie between these heights.
  float z_min() const;
  float z_max() const;
  const Cloth& cloth() const;

 private:
  TubeScene();
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace weftlight::reference
