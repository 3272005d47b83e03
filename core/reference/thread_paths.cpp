#include "reference/thread_paths.h"

#include <algorithm>
#include <cmath>

#include "cloth/layers.h"
#include "cloth/thickness.h"

namespace weftlight::reference {

using cloth::CentrePoint, cloth::CentreStep, cloth::centre_at, cloth::centre_lines, cloth::centre_step,
    cloth::furthest_side, cloth::layer_count, cloth::layer_of, cloth::one_layer, cloth::section_at, cloth::tallest_half,
    cloth::thread_formulas::section_norm;

namespace {

constexpr float kThinnest_mm = 1e-5f;

}  // namespace

void ThreadPaths::compute_lines() {
  layers_.clear(), lines_.clear();
  for (int i = 0; i < layer_count(cloth_); ++i) {
    layers_.push_back(one_layer(cloth_, i));
    lines_.push_back(centre_lines(layers_.back()));
  }
}

ThreadRing ThreadPaths::ring_at(System s, int thread, float along) const {
  const float period = period_along(s);
  const float wrapped = along - std::floor(along / period) * period;
  const size_t layer = static_cast<size_t>(layer_of(cloth_, s, thread));
  const Cloth& own = layers_[layer];
  const int in_layer = thread - (s == System::kWarp ? own.first_end : own.first_pick);
  const CentreStep step = centre_step(own, s, in_layer, wrapped);
  const CentrePoint p = centre_at(lines_[layer], s, in_layer, step);
  const glm::vec3 section = section_at(own, s, in_layer, step);
  const float next = section_at(own, s, in_layer, step.crossing + 1).z,
              sideways = (next - section_at(own, s, in_layer, step.crossing).z) / step.h1;
  return {along,
          p.height_mm,
          p.slope,
          glm::max(glm::vec2(section), glm::vec2(0.5f * kThinnest_mm)),
          section.z,
          sideways,
          threads(s)[static_cast<size_t>(thread)].squareness};
}

float ThreadPaths::widest(System s, int thread) const {
  const ThreadBody& body = threads(s)[static_cast<size_t>(thread)];
  const float side = cloth::uneven(body) ? furthest_side(body) : 0.5f * body.width_mm;
  return std::max(side + furthest_aside_, 0.5f * kThinnest_mm);
}

float ThreadPaths::thickest(System s) const { return tallest_half(cloth_, s); }

glm::vec2 section_edge(const ThreadRing& ring, float around_rad) {
  const glm::vec2 way(std::cos(around_rad), std::sin(around_rad));
  return way / section_norm(way.x * way.x, way.y * way.y, ring.squareness);
}
glm::vec3 axis_of(System s, float slope, float sideways) {
  return glm::normalize(s == System::kWarp ? glm::vec3(sideways, 1, slope) : glm::vec3(1, sideways, slope));
}
glm::vec3 across_of(System s) { return s == System::kWarp ? glm::vec3(1, 0, 0) : glm::vec3(0, 1, 0); }
glm::vec3 up_of(System s, float slope) {
  return glm::normalize(s == System::kWarp ? glm::vec3(0, -slope, 1) : glm::vec3(-slope, 0, 1));
}
glm::vec3 centre_of(System s, float centre_mm, const ThreadRing& r) {
  const float across = centre_mm + r.aside;
  return s == System::kWarp ? glm::vec3(across, r.along, r.z) : glm::vec3(r.along, across, r.z);
}

}  // namespace weftlight::reference
