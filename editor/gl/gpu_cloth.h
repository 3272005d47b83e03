#pragma once
// The packed maps of both faces on the GPU: one texture array a kind, the front's layers before the back's.

#include <array>

#include "gl/gl_objects.h"
#include "gl/names.h"
#include "render_data/packed_maps.h"
#include "render_data/thread_block.h"
#include "shaders/interop.h"

namespace weftlight::gl {

class GpuCloth {
 public:
  void upload(const PackedCloth& cloth);
  /// Gives up each map as soon as it is uploaded.
  void upload(PackedCloth&& cloth);
  void upload(const ClothPatches& patches);
  void upload_lobes(const ClothLobes& lobes);
  /// Binds the textures to their slots and the block of lobes.
  void bind();

  bool empty() const { return width_mm_ <= 0; }
  float width_mm() const { return width_mm_; }
  float depth_mm() const { return depth_mm_; }
  float mean_spacing_mm() const { return mean_spacing_mm_; }
  /// Whether each thread can be drawn as a body (thread_block.h).
  bool has_threads() const { return has_threads_; }
  ThreadKind thread_kind() const { return thread_kind_; }
  const interop::ClothData& data() const { return data_; }
  /// Of rung yarn on this cloth.
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
  void upload_crossings(const CellRect& cells, const std::vector<HalfCrossing>& texels);
  void upload_threads(const std::vector<glm::uvec4>& records);
  std::array<GlTexture, kPackedKinds> textures_;
  std::array<int, kPackedKinds> layers_{};  // of one face
  std::array<GlTexture, 4> cubes_;          // front half, front difference, back half, back difference
  GlTexture albedo_, albedo_mean_, fuzz_;   // of no design: made once
  GlTexture response_, slopes_, seen_;      // of the cloth and its lobes
  GlTexture threads_, crossings_;
  int crossing_blocks_ = 1;  // from one row of blocks to the next
  bool has_threads_ = false;
  ThreadKind thread_kind_;
  GlBuffer block_;
  interop::ClothData data_{};
  ThreadErrors errors_;
  float width_mm_ = 0, depth_mm_ = 0, mean_spacing_mm_ = 0;
  size_t bytes_ = 0;
};

}  // namespace weftlight::gl
