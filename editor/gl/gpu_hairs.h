#pragma once
// Stray fibres on the GPU: one draw, an instance a fibre. Sown again only when view, mesh or yarns change.

#include <string>

#include "gl/gl_objects.h"
#include "gl/gpu_mesh.h"
#include "gl/names.h"
#include "upload/stray_hairs.h"

namespace weftlight::gl {

class GpuHairs {
 public:
  bool build(std::string& error);
  /// A new mesh: its edges are sought again.
  void forget() { known_mesh_ = false; }
  void sow(const GpuMesh& mesh, const HairGrowth& growth, const HairView& view);
  size_t count() const { return count_; }
  /// Over what is there, with the frame's and the cloth's blocks and textures bound. `pieces` as in
  /// FrameData::hair.
  void draw(int pieces);

 private:
  GlProgram program_;
  GlVertexArray array_;
  GlBuffer roots_;
  std::vector<Hem> hems_;
  HairGrowth growth_;
  HairView view_;
  size_t count_ = 0;
  bool known_mesh_ = false;
};

/// Pieces that show the longer fibres without corners.
int hair_pieces(const HairGrowth& growth, float pixel_mm);

}  // namespace weftlight::gl
