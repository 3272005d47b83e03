#pragma once
// The fibres of a patch of cloth as curves for ray tracing: each thread's plies, fibres, hairs and loops
// (core/cloth/yarn_fibres.h), laid along the same centre lines and sections as the tubes. Cloth space, millimetres.
//
// Where a whole number of periods is no larger than the patch with its margins, the fibres repeat with them and the
// cloth is infinite that way; otherwise it ends beyond the margins.

#include <cstdint>
#include <glm/glm.hpp>
#include <memory>

#include "base/result.h"
#include "light/formulas.h"
#include "reference/fibre_patch.h"

namespace weftlight::reference {

struct FibreHit {
  float t = 0;
  glm::vec3 centre;  // on the axis
  glm::vec3 axis;    // unit
  float radius_mm = 0;
  uint32_t yarn = 0;
  float depth = 1;   // of its dye, relative to the cloth's; optics has it
  float offset = 0;  // of the ray from the axis, in radii, towards cross(axis, -direction)
  formulas::FibreOptics optics;
};

class FibreScene {
 public:
  /// An error if the patch needs more than max_bytes, with the figure.
  static base::Result<std::unique_ptr<FibreScene>> build(const Cloth& cloth, const FibreOptions& options);
  ~FibreScene();
  FibreScene(const FibreScene&) = delete;
  FibreScene& operator=(const FibreScene&) = delete;

  /// Closest fibre along the ray from t_min on. False: the ray leaves the cloth.
  bool intersect(glm::vec3 origin, glm::vec3 direction, float t_min, FibreHit& hit) const;
  bool occluded(glm::vec3 origin, glm::vec3 direction, float t_min) const;

  const Cloth& cloth() const;
  const FibreFigures& figures() const;
  /// The most that was allocated while the scene was built.
  int64_t peak_bytes() const;
  /// All fibres lie between these heights; and those without the hairs.
  float z_min() const;
  float z_max() const;
  float thickness_mm() const;

 private:
  FibreScene();
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace weftlight::reference
