#pragma once
// The ray-traced cloth in the preview's scene, with the same camera, lights, drape and form, so that only the cloth
// differs. For `weftlight reference` and the comparison in the window.

#include <memory>
#include <stop_token>
#include <string>
#include <vector>

#include "design/design.h"
#include "files/files.h"
#include "reference/picture.h"
#include "scene/camera.h"
#include "scene/light_rig.h"

namespace weftlight::render_data {

using design::ClothPlan, design::Design, design::Finish, design::Scene, design::Yarn;
using draft::Draft, draft::Face;
using drape::Mesh;
using files::Image;
using reference::DrapePicture, reference::FibreFigures, reference::FibreScene, reference::MeshScene,
    reference::Progress, reference::TracedImage, reference::TubeOptions, reference::TubeScene;
using scene::Bounds, scene::LightRig;

/// View and quality of a traced picture.
struct ReferenceView {
  Scene scene;
  int width = 0, height = 0;
  float yarns_per_pixel = 0;  // > 0: overrides the scene's distance
  Face front = Face::kFront;
  int spp = 64;
  int bounces = 2;       // between threads; with 0, one reflection stands for all of them
  bool fibres = false;   // as fibres; prepare_fibres() with the same view comes first
  int first_sample = 0;  // see DrapePicture
  uint64_t seed = 0;     // see DrapePicture
  bool layers = false;   // see PixelLayers; not with fibres
  int threads = 0;       // 0: all cores
  std::stop_token stop;
};

/// What is traced. The fibres are made for a view, by prepare_fibres().
enum class TracedThreads : uint8_t { kTubes, kFibres };

class ReferenceScene {
 public:
  /// Updates to the design; what it shares with the previous one is kept.
  base::Result<void> update(const Design& design, const TubeOptions& options = {},
                            TracedThreads traced = TracedThreads::kTubes);
  /// Makes the fibres of what the view shows, after a successful update. An error if they need more than max_bytes.
  base::Result<FibreFigures> prepare_fibres(const ReferenceView& view, int64_t max_bytes = int64_t{2} << 30);
  /// The most memory that the fibres took, bytes; 0 before prepare_fibres().
  int64_t fibre_bytes() const { return fibres_ ? fibres_->peak_bytes() : 0; }
  /// After a successful update.
  TracedImage trace(const ReferenceView& view, const Progress& progress) const;

 private:
  base::Result<void> update_threads(const Design& design, const TubeOptions& options, TracedThreads traced);
  base::Result<void> update_drape(const Design& design);
  base::Result<void> update_lights(const std::string& name);
  DrapePicture picture_of(const ReferenceView& view) const;

  Draft draft_;
  std::vector<Yarn> yarns_;
  Finish finish_;
  ClothPlan plan_;
  float mean_spacing_ = 0;  // mm
  std::string mesh_name_, lights_name_;
  std::unique_ptr<TubeScene> tubes_;
  std::unique_ptr<FibreScene> fibres_;
  Mesh mesh_;
  Bounds bounds_;
  std::unique_ptr<MeshScene> drape_, body_;
  LightRig rig_;
};

/// Composites the traced cloth over the preview without its cloth (Frame::cloth false), display-referred or linear. A
/// smaller traced picture is enlarged.
void lay_over(Image& picture, const TracedImage& traced, float exposure_ev, bool linear);

}  // namespace weftlight::render_data
