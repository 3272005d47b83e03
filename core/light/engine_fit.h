#pragma once
// How an engine's material comes nearest to the measured cloth: base colour, reflectance, the widths of the highlight
// and the sheen, so that what it sends over views and lights is what the cloth sends. Engines know nothing of threads
// that hide each other: with the cloth's own colours they come out too bright, the more so the flatter the view, and
// with the spread of its normals for a roughness they lose the highlight.

#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "light/cloth_response.h"
#include "light/engine_texels.h"
#include "light/formulas.h"
#include "light/names.h"

namespace weftlight::light {

/// Places on the threads at which the answer is measured that sets are fitted to: means then hold 4 percent.
inline constexpr int kFitSamples = 512;

/// What an engine's material has.
struct EngineModel {
  int sheen = formulas::kSheenCharlie;
  float most_f0 = 1;    // of its dielectric; kEngineF0: it cannot be changed
  bool grazing = true;  // the reflectance at grazing angles can be given apart; else it is 1
  bool anisotropic = true;
};

struct EngineFit {
  glm::vec3 base{1};  // factors of base colour; of sheen's colour
  float f0 = formulas::kEngineF0, f90 = 1;
  float sheen = 1;
  float sheen_roughness = 0.5f;
  glm::vec2 lobe{1, 1};  // factors of the footprint's variances along the fibres and across
  /// As engines whose Specular is 1/2 for the usual reflectance, and its double.
  float specular() const { return 0.5f * f0 / formulas::kEngineF0; }
  float error = 0;  // relative RMSE over views (to 79 degrees) and lights, and over the means of views, which count
                    // four times as much
};

/// One pair of directions (x along the weft, y along the warp, z out) and what cloth and fitted material send, for a
/// unit of irradiance at right angles: radiance.
struct EngineCheck {
  glm::vec3 view, light, cloth, engine;
};
/// Straight on and at 43, 59, 71 and 79 degrees along warp and weft, lit from 43 degrees along warp, then along weft.
std::vector<EngineCheck> check_engine(const EngineTexels& texels, const Cloth& cloth, const ClothResponse& response,
                                      const EngineModel& model, const EngineFit& fit);

/// How near the material comes from one elevation of the view, over all azimuths and lights to 79 degrees; luminance.
struct EngineScore {
  float view_deg = 0;
  float mean = 1;   // over that of the cloth
  float error = 0;  // RMS of the difference over the RMS of the cloth
};
/// At 0, 43, 59, 71 and 79 degrees.
std::vector<EngineScore> score_engine(const EngineTexels& texels, const Cloth& cloth, const ClothResponse& response,
                                      const EngineModel& model, const EngineFit& fit);

/// Deterministic.
EngineFit fit_engine(const EngineTexels& texels, const Cloth& cloth, const ClothResponse& response,
                     const EngineModel& model);

}  // namespace weftlight::light
