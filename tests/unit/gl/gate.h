#pragma once
// Shared by the renderer's gates: a twill of two colours, flat patches of it, and unfiltered shading.

#include <algorithm>
#include <cmath>
#include <vector>

#include "../figures.h"
#include "../relative_rms.h"
#include "picture.h"

namespace weftlight::gl {

using design::Design, design::Method;
using draft::Threads;
using files::Image;
using render_data::Effort, render_data::FlatPatch, render_data::PackedCloth, render_data::Stages, render_data::twill;

inline glm::vec3 towards(float azimuth, float elevation) {
  return {std::cos(azimuth) * std::cos(elevation), std::sin(azimuth) * std::cos(elevation), std::sin(elevation)};
}

inline double luminance(const float* p) { return static_cast<double>(p[0] + p[1] + p[2]) / 3; }

/// Mean of a channel, or of the luminance.
inline double mean(const Image& image, int channel = -1) {
  double sum = 0;
  for (size_t i = 0; i < image.texels.size(); i += 4) {
    sum +=
        channel < 0 ? luminance(&image.texels[i]) : static_cast<double>(image.texels[i + static_cast<size_t>(channel)]);
  }
  return sum / (static_cast<double>(image.texels.size()) / 4);
}

class Gate : public PictureTest {
 protected:
  static constexpr float kPi = 3.14159265f;
  static constexpr float kSpacing = 0.5f;  // mm
  static constexpr int kPeriod = 8;        // yarns
  static constexpr int kFine = 16;         // pixels a yarn of unfiltered shading

  static constexpr int kSamples = 13;  // a pixel close up, so that tests compare methods, not noise

  void SetUp() override {
    PictureTest::SetUp();
    if (IsSkipped() || HasFatalFailure()) return;
    design = twill(4, 2, {0.85f, 0.8f, 0.7f}, {0.1f, 0.15f, 0.4f});
  }
  static void TearDownTestSuite() {
    full_updates.clear();
    PictureTest::TearDownTestSuite();
  }
  /// kQuick makes the maps of a moving picture, a quarter as wide. Full updates take seconds, and most gates look at
  /// the same cloth: they are kept.
  void upload_maps(const Design& of, Effort effort = Effort::kFull) {
    const auto known =
        std::find_if(full_updates.begin(), full_updates.end(), [&](const FullUpdate& f) { return f.design == of; });
    if (effort == Effort::kFull && known != full_updates.end()) return renderer->upload(known->packed);
    stages = Stages();
    stages.update(std::make_shared<const Design>(of), effort);
    renderer->upload(stages.packed());
    if (effort == Effort::kFull) full_updates.push_back({of, stages.packed()});
  }
  /// Lays out and uploads the design: threads with spacing kSpacing; `fill`: width of a thread over its spacing.
  void lay(float fill, Effort effort = Effort::kFull) {
    for (Threads* t : {&design.draft.warp, &design.draft.weft}) {
      t->spacing_mm.assign(t->color.size(), kSpacing);
      t->thickness_mm.assign(t->color.size(), 0.85f * kSpacing * fill);
    }
    upload_maps(design, effort);
  }
  Image patch(Method method, float yarns, int pixels, glm::vec2 corner_mm = {0, 0},
              glm::vec3 light = towards(0.8f, 0.9f), glm::vec3 view = {0, 0, 1}) {
    FlatPatch p;
    p.width = p.height = pixels;
    p.corner_mm = corner_mm;
    p.step_x_mm = {yarns * kSpacing, 0}, p.step_y_mm = {0, yarns * kSpacing};
    p.light_towards = light, p.view = view;
    p.samples = kSamples;
    look.method = method;
    renderer->draw_patch(p, look);
    return renderer->read_patch();
  }
  /// Whole periods, whatever the footprint.
  Image period(Method method, float yarns) {
    return patch(method, yarns, std::max(8, static_cast<int>(std::lround(kPeriod / yarns))));
  }
  /// Points of a fine picture of the period are what unfiltered shading shows at any footprint.
  Image fine_period() { return patch(Method::kYarn, 1.0f / kFine, kPeriod * kFine); }
  /// At a position in yarns; the cloth is infinite.
  static double unfiltered(const Image& fine, double u, double v) {
    const auto texel = [](double at) {
      const double repeats = at / kPeriod;
      return std::min(static_cast<size_t>((repeats - std::floor(repeats)) * kPeriod * kFine),
                      static_cast<size_t>(kPeriod * kFine - 1));
    };
    return luminance(&fine.texels[4 * (texel(v) * static_cast<size_t>(fine.width) + texel(u))]);
  }
  /// Values of the middles of pixels x pixels, `yarns` wide, from a corner in yarns on.
  static std::vector<double> unfiltered(const Image& fine, double yarns, int pixels, double corner = 0) {
    std::vector<double> values;
    for (int y = 0; y < pixels; ++y) {
      for (int x = 0; x < pixels; ++x)
        values.push_back(unfiltered(fine, corner + (x + 0.5) * yarns, corner + (y + 0.5) * yarns));
    }
    return values;
  }

  struct FullUpdate {
    Design design;
    PackedCloth packed;
  };
  static inline std::vector<FullUpdate> full_updates;
  Design design;
  Stages stages;  // of the last upload that was none of those
};

}  // namespace weftlight::gl
