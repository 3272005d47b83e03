#pragma once
// Flyaway fibres on the GPU: one instanced draw. Scattered again only when view, mesh or yarns change.

#include <string>

#include "base/result.h"
#include "gl/gl_objects.h"
#include "gl/gpu_mesh.h"
#include "render_data/flyaways.h"

namespace weftlight::gl {

using render_data::FlyawayGrowth, render_data::FlyawayView, render_data::Hem;

class GpuFlyaways {
 public:
  base::Result<void> build();
  /// Call for a new mesh: its hems are computed again.
  void invalidate() { known_mesh_ = false; }
  void scatter(const GpuMesh& mesh, const FlyawayGrowth& growth, const FlyawayView& view);
  size_t count() const { return count_; }
  /// Draws over the current target, with the blocks and textures of frame and cloth bound. `pieces`: as in
  /// FrameData::flyaway.
  void draw(int pieces);

 private:
  GlProgram program_;
  GlVertexArray array_;
  GlBuffer roots_;
  std::vector<Hem> hems_;
  FlyawayGrowth growth_;
  FlyawayView view_;
  size_t count_ = 0;
  bool known_mesh_ = false;
};

/// Segments that show the longer fibres without corners.
int flyaway_pieces(const FlyawayGrowth& growth, float pixel_mm);

}  // namespace weftlight::gl
