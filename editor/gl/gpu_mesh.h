#pragma once
// A prepared mesh on the GPU: cloth, body, and the triangles of the cloth in drawing order.

#include <vector>

#include "gl/gl_objects.h"
#include "render_data/ambient.h"

namespace weftlight::gl {

using drape::Mesh;
using render_data::PreparedMesh, render_data::SkyVisibility;

enum class TriangleOrder { kFrontToBack, kBackToFront };

class GpuMesh {
 public:
  void upload(PreparedMesh mesh);
  const PreparedMesh& prepared() const { return prepared_; }
  /// Texture coordinate of the vertex buffer's origin, mm.
  std::array<double, 2> uv_origin_mm() const { return uv_origin_; }

  /// Sorts the triangles back to front for blending, front to back for early depth tests. `coarse`: use the simplified
  /// triangles.
  void sort(glm::vec3 eye, TriangleOrder order, bool coarse);
  void draw_cloth();
  void draw_body();
  GLuint ground_sky() const { return ground_sky_.name(); }

 private:
  struct Part {
    GlVertexArray array;
    GlBuffer vertices, indices;
    int count = 0;
  };
  void fill(Part& part, const Mesh& mesh, const std::vector<SkyVisibility>& sky, const std::vector<uint32_t>& index);

  PreparedMesh prepared_;
  Part cloth_, body_;
  GlTexture ground_sky_;
  std::array<double, 2> uv_origin_{};
  glm::vec3 sorted_for_{0};
  TriangleOrder order_ = TriangleOrder::kFrontToBack;
  bool coarse_ = false, sorted_ = false;
};

}  // namespace weftlight::gl
