#pragma once
// The bench of the chart: each cloth on the GPU and as tubes, and the measurements of one method at one place.

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "commands/chart_error.h"
#include "commands/chart_rows.h"
#include "commands/chart_scene.h"
#include "commands/names.h"
#include "gl/context.h"
#include "gl/renderer.h"
#include "reference/picture.h"
#include "upload/packed_maps.h"

namespace weftlight::commands {

/// The traced patch, twice, with other random numbers.
struct Truth {
  Pixels half, other_half;
};

class ChartBench {
 public:
  /// Null with the exit code and `error` set: no graphics, or a preset that cannot be read.
  static std::unique_ptr<ChartBench> create(const ChartEffort& effort, int& code, std::string& error);

  /// Methods that the renderer draws as themselves.
  std::vector<Method> methods();
  /// All figures of a row; empty with `error` set.
  std::optional<ChartRow> measure(const ChartRow& cell, std::string& error);
  /// Mean reflected light over that of a white Lambertian under the same light: by the method, or traced.
  std::optional<double> brightness(size_t scene, double view_deg, std::optional<Method> method, std::string& error);
  double truth_noise(const ChartRow& cell, std::string& error);
  /// What auto chooses by from now on.
  void use_ladder(const Ladder& ladder);
  /// Graphics, formulas and figures: rows of another fingerprint are measured anew.
  std::string fingerprint() const;
  std::string device() const { return renderer_->device(); }

 private:
  struct Loaded {
    Cloth cloth;
    PackedCloth packed;
    std::unique_ptr<TubeScene> tubes;
    std::map<std::pair<int, double>, Truth> truths;
  };
  ChartBench() = default;
  Loaded* load(size_t scene, std::string& error);
  bool show(size_t scene, std::string& error);
  const Truth* truth(const ChartRow& cell, std::string& error);
  Pixels draw(Method method, double view_deg, glm::vec2 corner, const PixelSteps& steps, int width, int height,
              int samples = FlatPatch{}.samples);
  Pixels supersampled(const ChartRow& cell, const FineGrid& grid, const PixelSteps& pixel);
  double filtering_error(const ChartRow& cell, const PixelSteps& pixel);
  double flicker(const ChartRow& cell, const PixelSteps& pixel);
  double nanoseconds(const ChartRow& cell, const PixelSteps& pixel);
  double instructions(const ChartRow& cell);
  double rung_instructions(size_t scene, int view_deg, Method method, double yarns);

  ChartEffort effort_;
  std::unique_ptr<HeadlessContext> context_;  // outlives the renderer
  std::unique_ptr<Renderer> renderer_;
  std::array<std::unique_ptr<Loaded>, kChartScenes.size()> loaded_;
  std::optional<size_t> shown_;
  Ladder ladder_;
  std::map<std::tuple<size_t, int, Method>, double> counted_;
};

/// Texture memory that a method reads, both faces.
double method_bytes(const PackedCloth& cloth, Method method);

}  // namespace weftlight::commands
