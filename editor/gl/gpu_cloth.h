#pragma once
// The packed maps of both faces on the GPU: a texture array for each kind, with the front's layers before the back's.

#include <array>

#include "gl/gl_objects.h"
#include "render_data/packed_maps.h"
#include "render_data/thread_block.h"
#include "shaders/interop.h"

namespace weftlight::gl {

using draft::CellRect;
using light::ThreadErrors;
using render_data::ClothLobes, render_data::ClothPatches, render_data::HalfCrossing, render_data::PackedCloth,
    render_data::ResponseTables, render_data::ThreadKind, render_data::kPackedKinds;

class GpuCloth {
 public:
  void upload(const PackedCloth& cloth);
  /// Frees each map as soon as it is uploaded.
  void upload(PackedCloth&& cloth);
  void upload(const ClothPatches& patches);
  void upload_lobes(const ClothLobes& lobes);
  /// Binds the textures and the uniform block of the cloth.
  void bind();
  /// The uniform block alone, which every program declares: WebGL draws nothing without it.
  void bind_block() { glBindBufferBase(GL_UNIFORM_BUFFER, kClothBinding, block_.get()); }

  bool empty() const { return width_mm_ <= 0; }
  float width_mm() const { return width_mm_; }
  float depth_mm() const { return depth_mm_; }
  float mean_spacing_mm() const { return mean_spacing_mm_; }
  /// Whether threads can be drawn one by one (thread_block.h).
  bool has_threads() const { return has_threads_; }
  ThreadKind thread_kind() const { return thread_kind_; }
  const interop::ClothData& data() const { return data_; }
  /// Measured errors of method yarn on this cloth.
  const ThreadErrors& errors() const { return errors_; }
  size_t bytes() const { return bytes_; }

 private:
  void upload_tables();
  template <class Cloth>
  void upload_all(Cloth& cloth);
  template <class Texture>
  void upload_maps(size_t k, Texture& front, Texture& back);
  void upload_rest(const PackedCloth& cloth);
  void upload_response(const ResponseTables& tables);
  void upload_crossings(const PackedCloth& cloth);
  void upload_crossings(const CellRect& cells, const std::vector<HalfCrossing>& texels, int first_layer);
  void upload_strips(const PackedCloth& cloth);
  void upload_strips(size_t first, const std::vector<uint32_t>& strips);
  void upload_threads(const std::vector<glm::uvec4>& records);
  std::array<GlTexture, kPackedKinds> textures_;
  std::array<int, kPackedKinds> layers_{};  // of one face
  std::array<GlTexture, 4> cubes_;          // front half, front difference, back half, back difference
  GlTexture albedo_, albedo_mean_, fuzz_;   // independent of the design: made once
  GlTexture response_, slopes_, views_;     // of the cloth and its lobes
  GlTexture threads_, crossings_;
  int crossing_blocks_ = 1;  // blocks in a row
  int crossing_layers_ = 1;  // of all crossings; as many more hold how far threads are moved sideways
  bool has_threads_ = false;
  ThreadKind thread_kind_;
  GlBuffer block_;
  interop::ClothData data_{};
  ThreadErrors errors_;
  float width_mm_ = 0, depth_mm_ = 0, mean_spacing_mm_ = 0;
  size_t bytes_ = 0;
};

}  // namespace weftlight::gl
