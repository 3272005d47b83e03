#pragma once
// Where each thread of the cloth runs, and its section there: the one geometry of the traced tubes and fibres. Cloth
// space, millimetres; threads are periodic and infinite.

#include <glm/glm.hpp>
#include <vector>

#include "cloth/centre_line.h"
#include "cloth/cloth.h"
#include "cloth/washed_aside.h"

namespace weftlight::reference {

using cloth::CentreLines, cloth::Cloth, cloth::ThreadBody;
using draft::System;

/// A section of a thread on its centre line.
struct ThreadRing {
  float along, z, slope;
  glm::vec2 radii;   // half width, half height
  float aside;       // of its centre, across
  float sideways;    // d aside / d along
  float squareness;  // shaders/thread_section.glsl
};

class ThreadPaths {
 public:
  ThreadPaths() = default;
  /// Sizes only: cheap for a cloth of any size.
  explicit ThreadPaths(const Cloth& cloth) : cloth_(cloth), furthest_aside_(cloth::furthest_aside(cloth)) {}
  /// The centre lines, which ring_at() needs; 8 bytes a crossing of the period.
  void compute_lines();

  const Cloth& cloth() const { return cloth_; }
  const std::vector<ThreadBody>& threads(System s) const { return s == System::kWarp ? cloth_.ends : cloth_.picks; }
  float period_along(System s) const { return s == System::kWarp ? cloth_.depth_mm : cloth_.width_mm; }
  float period_across(System s) const { return s == System::kWarp ? cloth_.width_mm : cloth_.depth_mm; }
  /// At a position along, which may lie outside the period.
  ThreadRing ring_at(System s, int thread, float along) const;
  /// Upper bounds of how far a thread reaches to a side, and of the half height of all.
  float widest(System s, int thread) const;
  float thickest(System s) const;

 private:
  Cloth cloth_;
  float furthest_aside_ = 0;
  std::vector<Cloth> layers_;
  std::vector<CentreLines> lines_;  // by layer
};

/// A point of a section in its half sizes, across and up, in the direction of an angle from +across.
glm::vec2 section_edge(const ThreadRing& ring, float around_rad);
/// Directions and position of a section: along the thread, across it in the plane of the cloth, up.
glm::vec3 axis_of(System s, float slope, float sideways = 0);
glm::vec3 across_of(System s);
glm::vec3 up_of(System s, float slope);
glm::vec3 centre_of(System s, float centre_mm, const ThreadRing& ring);

}  // namespace weftlight::reference
