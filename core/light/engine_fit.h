#pragma once
// Fits an engine's material to the far-field reflectance of a cloth: base colour, reflectance, highlight widths and
// sheen. Engines know nothing of threads that hide each other: with the cloth's own colours they come out too bright,
// the more so at flat views, and with the spread of its normals as roughness they lose the highlight.

#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "light/cloth_response.h"
#include "light/engine_texels.h"
#include "light/engine_tint.h"
#include "light/formulas.h"

namespace weftlight::light {

using cloth::Cloth;

/// Surface samples for the response that sets are fitted to: means are then within 4 percent.
inline constexpr int kFitSamples = 512;

/// Capabilities of an engine's material.
struct EngineModel {
  int sheen = formulas::kSheenCharlie;
  float most_f0 = 1;    // largest reflectance of its dielectric; kEngineF0: fixed
  bool grazing = true;  // the reflectance at grazing angles can be set; else it is 1
  bool anisotropic = true;
  bool tinted = false;  // its reflectance at normal view has a colour
  // Weight of the means in the planes along warp and weft, over that of the shape of the response. More brings these
  // nearer at some cost of the shape, for models that can tell the planes apart.
  float planes = 0.3f;
  // The engine averages the light of texels instead of texels: widths of the highlight and relief of the normals are
  // fitted for each texel.
  bool each_texel = false;
  bool view_tinted = false;   // base colour and reflectance can change with the view
  bool light_tinted = false;  // and with the light, in the same way: reciprocal
};

/// Of glTF, which method `engine` shows.
inline constexpr EngineModel kGltfModel{
    .sheen = formulas::kSheenCharlie, .most_f0 = 1, .grazing = true, .anisotropic = true, .tinted = true, .planes = 20};

struct EngineFit {
  glm::vec3 base{1};  // factors of the base colour
  ViewTint tint;
  glm::vec3 f0{formulas::kEngineF0};
  float f90 = 1;
  glm::vec3 sheen{1};  // factors of the sheen's colour
  float sheen_roughness = 0.5f;
  LobeScale lobe;
  glm::vec2 relief{1};  // factors of the slopes of the normals along weft and warp, for models that light each texel
  bool has_sheen() const { return sheen.r > 0 || sheen.g > 0 || sheen.b > 0; }
  /// For engines whose Specular of 1/2 is the usual reflectance and of 1 twice that.
  float specular() const { return 0.5f * f0.g / formulas::kEngineF0; }
  float error = 0;  // relative RMSE over views (to 75 degrees), lights, and the means of views
};

/// Radiance of cloth and fitted material for one pair of directions (x along the weft, y along the warp, z out), for
/// unit irradiance at normal incidence.
struct EngineCheck {
  glm::vec3 view, light, cloth, engine;
};
/// At 0, 43, 59, 71 and 79 degrees along warp and weft, lit from 43 degrees along the warp, then along the weft.
std::vector<EngineCheck> check_engine(const EngineTexels& texels, const Cloth& cloth, const ClothResponse& response,
                                      const EngineModel& model, const EngineFit& fit);

/// Accuracy of the material at one view elevation, over all azimuths and lights to 79 degrees; luminance.
struct EngineScore {
  float view_deg = 0;
  float mean = 1;   // over that of the cloth
  float error = 0;  // RMS of the difference over the RMS of the cloth
};
/// At 0, 43, 59, 71 and 79 degrees.
std::vector<EngineScore> score_engine(const EngineTexels& texels, const Cloth& cloth, const ClothResponse& response,
                                      const EngineModel& model, const EngineFit& fit);

enum class EnginePlane { kWarp, kWeft };
/// The same for views and lights in one plane, along the warp or along the weft, at 0, 30, 60 and 75 degrees, with
/// lights to 80 degrees from the normal.
std::vector<EngineScore> score_plane(const EngineTexels& texels, const Cloth& cloth, const ClothResponse& response,
                                     const EngineModel& model, const EngineFit& fit, EnginePlane plane);

/// Deterministic. near: the fit of a neighbour with the same model, the other face or a finer level of detail, or null;
/// where the errors are within some per cent, the fit is the one beside it, so that neighbours look alike.
EngineFit fit_engine(const EngineTexels& texels, const Cloth& cloth, const ClothResponse& response,
                     const EngineModel& model, const EngineFit* near = nullptr);
/// For another model that reads the same images: with the widths of the highlight and the relief of a fit.
EngineFit refit_engine(const EngineTexels& texels, const Cloth& cloth, const ClothResponse& response,
                       const EngineModel& model, const EngineFit& fitted);

}  // namespace weftlight::light
