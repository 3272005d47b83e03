#pragma once
// One face of a cloth at the size of its images, made band by band, so that memory does not grow with the size. The
// whole face exists in few texels, for far-field properties, until release(); rows of the full size are supersampled on
// demand.

#include <array>
#include <memory>
#include <optional>

#include "cloth/cloth.h"
#include "light/engine_fit.h"
#include "light/engine_texels.h"
#include "texture_set/surface_texels.h"
#include "texture_set/tile.h"

namespace weftlight::texture_set {

using cloth::Cloth, cloth::Linear, cloth::Maps, cloth::Plane;
using light::ClothResponse, light::EngineCheck, light::EngineFit, light::EngineModel, light::EngineScore;

/// Size of the images in texels: the longer side has `size`, the other the power of two that keeps texels closest to
/// square, at least 16.
struct TextureSize {
  int width = 0, height = 0;
};
TextureSize texture_size(float width_mm, float depth_mm, int size);
/// Texels baked for each texel of a face of this size, per side: one for wide threads; otherwise at least two, for
/// smooth edges and a variance of the normals; more if threads are thinner than texels.
int supersampling(const Cloth& cloth, TextureSize size);

/// What a set keeps of the threads, for a level of detail.
enum class ThreadDetail {
  kAll,
  kNoShade,  // none of one thread on the next: occlusion, height and sheen are the same all over
  kColours   // the base colour and coverage alone: all else is the mean of the face
};
inline constexpr int kLods = 3;  // of ThreadDetail, by value

/// How a face reflects light, which does not depend on the engine.
using MeasuredLight = std::shared_ptr<const ClothResponse>;

struct FaceOptions {
  TextureSize size;
  bool horizon = false;  // there are horizons()
  bool fitted = true;    // colours, sheen and occlusion are fitted to an engine; false: those of the cloth
  EngineModel model;     // of the engine
  std::optional<EngineModel> older{};  // a second model, for older_fit()
  std::optional<EngineFit> near{};     // of the other face or a finer level of detail, beside which the fit stays
  MeasuredLight light{};  // of the same face and size, measured before; null: it is measured if it is needed
  ThreadDetail detail = ThreadDetail::kAll;
  float footprint_mm = 0;  // of a pixel, whose microfacets the roughness includes; 0: those of a texel only
};

/// Means over the texels of small().
struct FaceMeans {
  double roughness = 0, aspect = 0;  // aspect: anisotropy, narrow / wide = 1 - 0.9 a
  double sheen = 0, metal = 0, transmitted = 0;
};

/// Deterministic: the bits do not depend on the bands.
class FaceSource {
 public:
  FaceSource(Tile tile, const FaceOptions& options);
  const Tile& tile() const { return tile_; }
  const Cloth& cloth() const { return tile_.cloth; }
  /// The whole face, at most 1024 texels a side.
  const SurfaceTexels& small() const { return small_; }
  /// Rows [y0, y1) of the full size, without horizons; computed on the caller's thread only.
  SurfaceTexels rows(int y0, int y1) const;
  /// The same rows before the fit.
  SurfaceTexels raw_rows(int y0, int y1) const;
  /// Applies the fit to rows of a mip level (half_of() of raw rows) that start at row y0; the level has level_height
  /// rows.
  SurfaceTexels finished(SurfaceTexels raw, int y0, int level_height) const;
  /// Number of rows made at a time; a power of two that divides the height.
  int band() const { return band_; }
  const EngineFit& fit() const { return fit_; }
  /// The fit to FaceOptions::older; fit() if there is none.
  const EngineFit& older_fit() const { return older_fit_; }
  /// What the fit was made to; FaceOptions::light if there was none.
  const MeasuredLight& light() const { return light_; }
  const std::vector<EngineCheck>& checks() const { return checks_; }
  const std::vector<EngineScore>& scores() const { return scores_; }
  /// Along the warp, then along the weft.
  const std::array<std::vector<EngineScore>, 2>& plane_scores() const { return plane_scores_; }
  float coverage() const { return coverage_; }  // mean, 0..1
  Linear mean_base() const { return mean_base_; }
  const FaceMeans& means() const { return means_; }
  TextureSize size() const { return options_.size; }
  /// Of the whole face, as in Maps, at most 2^22 texels each; size of an image of them.
  const std::vector<Plane<uint8_t>>& horizons() const { return horizons_; }
  TextureSize horizon_size() const { return horizon_size_; }
  /// Frees the horizons alone, which take as much as the texels.
  void release_horizons() { horizons_ = {}; }
  /// Frees all texels: from here on there are no rows, no horizons and no texels in small(). All else stays.
  void release();

 private:
  void make_whole();
  void make_raw();
  const SurfaceTexels* whole() const;
  void make_from_part();
  void measure(const Cloth& cloth, const Maps& maps);
  void measure_lean();
  void measure_footprints();
  void measure_footprint(SurfaceTexel& texel, const glm::vec3& lobe) const;
  void fit_facets(SurfaceTexel& texel) const;
  void measure_means();
  void measure_range();
  void measure_mean_texel();
  void leave_out_threads(SurfaceTexel& texel) const;
  void set_occlusion(SurfaceTexels& surface, int y0, int level_height) const;
  void finish(SurfaceTexels& surface, int y0, int level_height, int threads) const;
  SurfaceTexels piece(int x0, int x1, int y0, int y1) const;

  Tile tile_;
  FaceOptions options_;
  int factor_ = 1, band_ = 1;
  SurfaceTexels small_, whole_;  // whole_: empty where the face is too large for one piece
  std::vector<Plane<uint8_t>> horizons_;
  TextureSize horizon_size_{};
  // Of the coarse maps, or the mean of a part's repeats; empty: each piece computes its own, or has sharp_occlusion_.
  Plane<float> occlusion_, sharp_occlusion_;
  int occlusion_across_ = 1, occlusion_up_ = 1;  // repetitions of it in the face
  Plane<glm::vec3> footprints_;                  // covariance of the microfacets, scaled by the fit
  float weight_ = 0;                             // weight of the lobe of the footprint in that of a texel
  SurfaceTexel mean_texel_;                      // of the whole face, before the fit; its lobe as scaled by the fit
  MeasuredLight light_;
  EngineFit fit_, older_fit_;
  std::vector<EngineCheck> checks_;
  std::vector<EngineScore> scores_;
  std::array<std::vector<EngineScore>, 2> plane_scores_;
  glm::vec2 lean_{0};  // mean slope of the normals (light::straightened)
  float coverage_ = 1, occlusion_gain_ = 1;
  Linear mean_base_;
  FaceMeans means_;
};

}  // namespace weftlight::texture_set
