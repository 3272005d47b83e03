#pragma once
// The bench of the chart: each cloth on the GPU and as tubes, and the measurements of one method at one place.

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "commands/chart/counter.h"
#include "commands/chart/drapes.h"
#include "commands/chart/error.h"
#include "commands/chart/names.h"
#include "commands/chart/rows.h"
#include "commands/chart/scene.h"
#include "gl/context.h"
#include "gl/renderer.h"
#include "reference/picture.h"
#include "render_data/packed_maps.h"

namespace weftlight::chart {

/// The traced patch, twice, with other random numbers.
struct Truth {
  Pixels half, other_half;
};

struct LightRow {
  ChartRow cell;
  ChartLight light = ChartLight::kKey;
};

class ChartBench {
 public:
  /// Null with `error` set: no graphics. counter: counts instructions, if there is one.
  static std::unique_ptr<ChartBench> create(const ChartEffort& effort, std::unique_ptr<DrawCounter> counter,
                                            std::string& error);

  const ChartEffort& effort() const { return effort_; }
  /// Methods that the renderer draws as themselves.
  std::vector<Method> methods();
  /// All figures of a row; empty with `error` set.
  std::optional<ChartRow> measure(const ChartRow& cell, std::string& error);
  /// Mean reflected light over that of a white Lambertian under the same light: by the method, or traced.
  std::optional<double> brightness(size_t scene, double view_deg, std::optional<Method> method, std::string& error);
  /// Model error and mean brightness alone, under another light.
  std::optional<LightRow> under(ChartLight light, const ChartRow& cell, std::string& error);
  /// Milliseconds of a frame full of one cloth, seen straight on. Of a software renderer: processor time of a smaller
  /// patch, shared among its cores and scaled.
  std::optional<double> frame_ms(size_t scene, const Look& look, double yarns_per_pixel, std::array<int, 2> size,
                                 std::string& error);
  /// All figures of a row on the drape.
  std::optional<DrapeRow> draped(const DrapeRow& cell, std::string& error);
  double truth_noise(const ChartRow& cell, std::string& error);
  /// What auto chooses by from now on.
  void use_lod_table(const LodTable& lod_table);
  /// Graphics, formulas and figures: rows of another fingerprint are measured anew.
  std::string fingerprint() const;
  std::string device() const { return renderer_->device(); }
  /// Draws a patch and waits for it; false where the preset cannot be read.
  bool draw_counted(const CountedDraw& what, const LodTable& lod_table, int pixels);

 private:
  struct Loaded {
    PreparedMesh mesh;
    Cloth cloth;
    PackedCloth packed;
    std::unique_ptr<TubeScene> tubes;  // made when the first truth is asked for
    std::map<std::pair<int, double>, Truth> truths;
    std::map<std::pair<int, double>, Pixels> fine;  // supersampled, of rung yarn
    std::unique_ptr<MeshScene> hung, body;          // made when the first draped truth is asked for
    std::map<std::pair<ChartLight, double>, Truth> draped;
    std::map<std::tuple<ChartLight, double, int>, double> bare_ns;  // pictures of so many pixels without the cloth
  };
  ChartBench() = default;
  Loaded* load(size_t scene, std::string& error);
  const TubeScene* tubes(Loaded& loaded, std::string& error);
  bool show(size_t scene, std::string& error);
  const Truth* truth(const ChartRow& cell, std::string& error);
  FlatPatch patch_of(double view_deg, glm::vec2 corner, const PixelSteps& steps, int width, int height,
                     int samples) const;
  Pixels draw(Method method, double view_deg, glm::vec2 corner, const PixelSteps& steps, int width, int height,
              int samples = FlatPatch{}.samples);
  PixelSteps pixel_of(const ChartRow& cell) const;
  Pixels supersampled(const ChartRow& cell, const FineGrid& grid, const PixelSteps& pixel);
  double filtering_error(const ChartRow& cell, const PixelSteps& pixel);
  double flicker(const ChartRow& cell, const PixelSteps& pixel);
  double patch_ns(const FlatPatch& patch, const Look& look);
  double nanoseconds(const ChartRow& cell, const PixelSteps& pixel);
  double instructions(const ChartRow& cell);
  bool hang(size_t scene, std::string& error);
  const Truth& draped_truth(size_t scene, const DrapeRow& cell);
  double picture_ns(const DrapeRow& cell, const Frame& frame, FrameStats& stats);
  double draped_ns(size_t scene, const DrapeRow& cell);

  ChartEffort effort_;
  std::unique_ptr<HeadlessContext> context_;  // outlives the renderer
  std::unique_ptr<Renderer> renderer_;
  std::array<std::unique_ptr<Loaded>, kChartScenes.size()> loaded_;
  std::optional<size_t> shown_, hung_;
  LodTable lod_table_;
  std::unique_ptr<DrawCounter> counter_;
  std::map<std::tuple<size_t, Method, float, double>, double> frame_ns_;
  std::map<std::tuple<size_t, int, double, Method, int>, double> counted_;
};

/// What the measurements share: processor time of all threads of this process, its cores, a scene by its name (the
/// first where there is none), colours without alpha, the mean of both halves.
double processor_ns();
double cores();
size_t scene_named(const std::string& name);
Pixels colours(const Image& image);
Pixels colours(const TracedImage& image);
Pixels mean_of(const Truth& truth);

/// Texture memory that a method reads, both faces.
double method_bytes(const PackedCloth& cloth, Method method);

}  // namespace weftlight::chart
