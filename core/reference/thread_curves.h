#pragma once
// The plies, fibres, hairs and loops of one thread as curves along its centre line, in its sections. Cloth space,
// millimetres; a point of a curve is its position and, in w, its radius.

#include <glm/glm.hpp>
#include <vector>

#include "cloth/yarn_fibres.h"
#include "reference/fibre_plan.h"
#include "reference/thread_paths.h"

namespace weftlight::reference {

using cloth::PlyFibre, cloth::StrayFibre, cloth::YarnFibres;

/// A stray fibre and the copy of the patch, along the thread, that it stands in.
struct PlacedStray {
  StrayFibre fibre;
  float shift_mm = 0;
};

/// Straight pieces of a stray fibre; it has one point more.
int pieces_of(const StrayFibre& stray);

/// A planned thread with its fibres.
struct ThreadFibres {
  const PlannedThread* plan = nullptr;
  YarnFibres yarn;
  std::vector<PlacedStray> strays;
};

/// `thread` is one of the plan's, which outlives the result.
ThreadFibres thread_fibres(const FibrePlan& plan, const PlannedThread& thread);

/// A section of a thread as a frame.
struct SectionFrame {
  glm::vec3 centre, across, up, axis;
  glm::vec2 radii;
  float squareness;
  SectionFrame(System s, float centre_mm, const ThreadRing& ring)
      : centre(centre_of(s, centre_mm, ring)),
        across(across_of(s)),
        up(up_of(s, ring.slope)),
        axis(axis_of(s, ring.slope)),
        radii(ring.radii),
        squareness(ring.squareness) {}
  /// Of a point of the unit disc; what has this radius stays inside the section.
  glm::vec3 at(glm::vec2 p, float radius) const {
    // Circles around the centre become sections.
    const float norm = cloth::thread_formulas::section_norm(p.x * p.x, p.y * p.y, squareness),
                fuller = norm > 0 ? glm::length(p) / norm : 1.0f;
    const glm::vec2 inside = fuller * glm::max(radii - radius, glm::vec2(0));
    return centre + across * (inside.x * p.x) + up * (inside.y * p.y);
  }
  /// Of the circle with the area of the section.
  float mean_radius() const {
    return std::sqrt(radii.x * radii.y * cloth::thread_formulas::section_fullness(squareness));
  }
};

/// The references outlive it. The centre lines of `paths` are computed.
class ThreadCurves {
 public:
  ThreadCurves(const ThreadPaths& paths, const FibrePlan& plan, const ThreadFibres& made);

  /// The thread itself and one of its plies, with the radius of the circle of the same area; plan->points points.
  void thread(glm::vec4* out) const;
  void ply(int ply, glm::vec4* out) const;
  /// plan->points points.
  void fibre(const PlyFibre& fibre, glm::vec4* out) const;
  /// pieces_of() + 1 points.
  void stray(const PlacedStray& stray, glm::vec4* out) const;

 private:
  void hair(const StrayFibre& hair, const SectionFrame& from, glm::vec4* out) const;
  void loop(const StrayFibre& loop, float start_mm, glm::vec4* out) const;
  SectionFrame frame_at(float along_mm) const;
  float along(int point) const { return step_mm_ * static_cast<float>(point) - plan_.pad_mm; }

  const ThreadPaths& paths_;
  const FibrePlan& plan_;
  const ThreadFibres& made_;
  float step_mm_ = 0;
  std::vector<SectionFrame> frames_;  // at the points
};

}  // namespace weftlight::reference
