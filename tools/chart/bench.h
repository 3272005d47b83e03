#pragma once
// The measurements of the chart: each cloth on the GPU and as ray-traced tubes; one method under one set of conditions.

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "base/result.h"
#include "chart/chart_rows.h"
#include "chart/counter.h"
#include "chart/drapes.h"
#include "chart/error.h"
#include "chart/fibre_rows.h"
#include "chart/scene.h"
#include "gl/headless_context.h"
#include "gl/renderer.h"
#include "reference/picture.h"
#include "render_data/packed_maps.h"

namespace weftlight::chart {

using cloth::Cloth;
using design::Look, design::Method;
using files::Image;
using gl::Frame, gl::FrameStats, gl::HeadlessContext, gl::Renderer;
using light::LodTable;
using reference::MeshScene, reference::TracedImage, reference::TubeScene;
using render_data::FlatPatch, render_data::PackedCloth, render_data::PreparedMesh;

/// The traced patch as two halves with independent random numbers.
struct Truth {
  Pixels half, other_half;
};

struct LightRow {
  ChartRow cell;
  ChartLight light = ChartLight::kKey;
};

class ChartBench {
 public:
  /// An error without graphics. counter: counts instructions; may be null.
  static base::Result<std::unique_ptr<ChartBench>> create(const ChartEffort& effort,
                                                          std::unique_ptr<DrawCounter> counter);

  const ChartEffort& effort() const { return effort_; }
  /// The methods that this renderer supports.
  base::Result<std::vector<Method>> methods();
  /// All values of a row.
  base::Result<ChartRow> measure(const ChartRow& cell);
  /// Mean radiance divided by that of a white Lambertian under the same light; without a method it is traced.
  base::Result<double> brightness(size_t scene, double view_deg, std::optional<Method> method);
  /// Model error and mean brightness under another light.
  base::Result<LightRow> measure_under(ChartLight light, const ChartRow& cell);
  /// Milliseconds for a frame filled with one cloth at normal view. For a software renderer: processor time of a
  /// smaller patch, divided by the number of cores and scaled.
  base::Result<double> frame_ms(size_t scene, const Look& look, double yarns_per_pixel, std::array<int, 2> size);
  /// All values of a row on the drape.
  base::Result<DrapeRow> draped(const DrapeRow& cell);
  /// All near methods, and the traced tubes, against traced fibres.
  base::Result<std::vector<FibreRow>> against_fibres(size_t scene, int view_deg, double yarns_per_pixel);
  base::Result<double> truth_noise(const ChartRow& cell);
  /// Identifies graphics, shaders and effort; rows with another fingerprint are measured again.
  std::string fingerprint() const;
  std::string device() const { return renderer_->device(); }
  /// Draws a patch and waits for it; an error if the preset cannot be read.
  base::Result<void> draw_counted(const CountedDraw& what, const LodTable& lod_table, int pixels);

 private:
  struct Loaded {
    PreparedMesh mesh;
    Cloth cloth;
    PackedCloth packed;
    std::unique_ptr<TubeScene> tubes;  // built for the first truth
    std::map<std::pair<int, double>, Truth> truths;
    std::map<std::pair<int, double>, Pixels> fine;  // supersampled, of method yarn
    std::unique_ptr<MeshScene> drape, body;         // built for the first draped truth
    std::map<std::pair<ChartLight, double>, Truth> draped_truths;
    std::map<std::tuple<ChartLight, double, int>, double> bare_ns;  // picture of that many pixels without the cloth
  };
  ChartBench() = default;
  // The pointers are never null, and stay valid as long as this.
  base::Result<Loaded*> load(size_t scene);
  base::Result<const TubeScene*> tubes(Loaded& loaded);
  base::Result<Loaded*> show(size_t scene);
  base::Result<const Truth*> truth(const ChartRow& cell);
  reference::FlatPicture traced_patch(double view_deg, const PixelSteps& steps, int pixels, uint64_t seed) const;
  FlatPatch patch_of(double view_deg, glm::vec2 corner, const PixelSteps& steps, int width, int height,
                     int samples) const;
  Pixels draw(Method method, double view_deg, glm::vec2 corner, const PixelSteps& steps, int width, int height,
              int samples = FlatPatch{}.samples);
  PixelSteps pixel_of(const ChartRow& cell) const;
  Pixels supersampled(const ChartRow& cell, const FineGrid& grid, const PixelSteps& pixel);
  double filtering_error(const ChartRow& cell, const PixelSteps& pixel);
  double flicker(const ChartRow& cell, const PixelSteps& pixel);
  double patch_ns(const FlatPatch& patch, const Look& look);
  int timing_size(Method method) const;
  double nanoseconds(const ChartRow& cell, const PixelSteps& pixel);
  double instructions(const ChartRow& cell);
  base::Result<Loaded*> show_drape(size_t scene);
  const Truth& draped_truth(size_t scene, const DrapeRow& cell);
  double picture_ns(const DrapeRow& cell, const Frame& frame, FrameStats& stats);
  double draped_ns(size_t scene, const DrapeRow& cell);

  ChartEffort effort_;
  std::unique_ptr<HeadlessContext> context_;  // outlives the renderer
  std::unique_ptr<Renderer> renderer_;
  std::array<std::unique_ptr<Loaded>, kChartScenes.size()> loaded_;
  std::optional<size_t> shown_, draped_scene_;
  LodTable lod_table_;
  std::unique_ptr<DrawCounter> counter_;
  std::map<std::tuple<size_t, Method, float, double>, double> frame_ns_;
  std::map<std::tuple<size_t, int, double, Method, int>, double> counted_;
};

/// Helpers: number of cores, where a patch begins, index of a scene by its name (0 if unknown), colours without alpha,
/// mean of both halves.
double cores();
glm::vec2 chart_corner();  // of a patch on the cloth, mm
size_t scene_named(const std::string& name);
Pixels colours(const Image& image);
Pixels colours(const TracedImage& image);
Pixels mean_of(const Truth& truth);

/// Texture memory that a method reads, for both faces.
double method_bytes(const PackedCloth& cloth, Method method);

}  // namespace weftlight::chart
