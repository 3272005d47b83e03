#pragma once
// Stray fibres on the GPU: one draw, an instance a fibre. Sown again only when view, mesh or yarns change.

#include <string>

#include "gl/gl_objects.h"
#include "gl/gpu_mesh.h"
#include "gl/names.h"
#include "render_data/flyaways.h"

namespace weftlight::gl {

class GpuFlyaways {
 public:
  bool build(std::string& error);
  /// A new mesh: its edges are sought again.
  void forget() { known_mesh_ = false; }
  void sow(const GpuMesh& mesh, const FlyawayGrowth& growth, const FlyawayView& view);
  size_t count() const { return count_; }
  /// Over what is there, with the frame's and the cloth's blocks and textures bound. `pieces` as in
  /// FrameData::hair.
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

/// Pieces that show the longer fibres without corners.
int flyaway_pieces(const FlyawayGrowth& growth, float pixel_mm);

}  // namespace weftlight::gl
