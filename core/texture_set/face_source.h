#pragma once
// One face of a cloth at the size of its images, made band by band, so that memory does not grow with the size: the
// whole in few texels for what is known of it from afar, and rows of the full size with all their supersampling.

#include <memory>
#include <optional>

#include "cloth/cloth.h"
#include "light/engine_fit.h"
#include "light/engine_texels.h"
#include "texture_set/names.h"
#include "texture_set/surface_texels.h"

namespace weftlight::texture_set {

/// Texels of the images: the longer side has `size`, the other the nearest power of two that keeps texels
/// about square, at least 16.
struct TextureSize {
  int width = 0, height = 0;
};
TextureSize texture_size(float width_mm, float depth_mm, int size);

struct FaceOptions {
  TextureSize size;
  bool horizon = false;                // kept in small()
  bool fitted = true;                  // colours, sheen and occlusion as an engine needs them; false: the cloth's own
  EngineModel model;                   // that it is fitted to
  std::optional<EngineModel> older{};  // and what else: older_fit()
  float footprint_mm = 0;              // of a pixel, whose facets roughness holds; 0: of a texel alone
};

/// Deterministic: the same bits however many bands are asked for.
class FaceSource {
 public:
  FaceSource(Cloth cloth, const FaceOptions& options);
  const Cloth& cloth() const { return cloth_; }
  /// The whole face, at most 1024 texels a side.
  const Surface& small() const { return small_; }
  /// Rows [y0, y1) of the full size, without horizons; made by the caller's thread alone.
  Surface rows(int y0, int y1) const;
  /// The same before it is fitted, and a level of its mips fitted: half_of() of raw rows from row y0 of the level on,
  /// which has so many rows in all.
  Surface raw_rows(int y0, int y1) const;
  Surface finished(Surface raw, int y0, int level_height) const;
  /// Rows that are made at a time; a power of two that divides the height.
  int band() const { return band_; }
  const EngineFit& fit() const { return fit_; }
  /// The same cloth in the older model; fit() where there is none.
  const EngineFit& older_fit() const { return older_fit_; }
  const std::vector<EngineCheck>& checks() const { return checks_; }
  const std::vector<EngineScore>& scores() const { return scores_; }
  float coverage() const { return coverage_; }  // mean, 0..1
  Linear mean_base() const { return mean_base_; }
  TextureSize size() const { return options_.size; }

 private:
  void measure(const Maps& maps);
  void measure_footprints();
  void measure_footprint(SurfaceTexel& texel, const glm::vec3& lobe) const;
  void measure_means();
  void measure_range();
  void finish(Surface& surface, int y0, int whole_height, int threads) const;
  Surface piece(int x0, int x1, int y0, int y1) const;

  Cloth cloth_;
  FaceOptions options_;
  int factor_ = 1, band_ = 1;
  Surface small_, whole_;        // whole_: empty where the face is too large for one piece
  Plane<float> occlusion_;       // of the coarse maps; empty: each piece finds its own
  Plane<glm::vec3> footprints_;  // covariance of their facets, as the fit scales it
  float share_ = 0;              // how far a texel takes the lobe of its footprint for its own
  EngineFit fit_, older_fit_;
  std::vector<EngineCheck> checks_;
  std::vector<EngineScore> scores_;
  float coverage_ = 1, occlusion_gain_ = 1;
  Linear mean_base_;
};

}  // namespace weftlight::texture_set
