#pragma once
// How an engine's material comes nearest to the measured cloth: scales of base colour, specular and sheen, and the
// sheen's roughness, so that what it sends over views and lights is what the cloth sends. Engines know nothing of
// threads that hide each other: with the cloth's own colours they come out too bright, the more so the flatter the
// view.

#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "light/cloth_response.h"
#include "light/formulas.h"
#include "light/names.h"

namespace weftlight::light {

/// Covariance (xx, xy, yy) of the micro-slopes of a yarn's facets about their normal, over the axes of the texture.
glm::vec3 facet_covariance(const glm::vec3& normal, const glm::vec3& fibre, const Lobes& lobes);
/// GGX's alphas for it, 0..1, the wider first, and the wider one's direction in (x, y): alpha = sqrt(2 variance).
struct FacetAlphas {
  glm::vec2 alpha{1, 1};
  glm::vec2 axis{1, 0};
};
FacetAlphas facet_alphas(const glm::vec3& covariance);

/// Part of a texture set as an engine sees it, before the fit.
struct EngineTexel {
  formulas::EngineMaterial material;
  glm::vec3 normal{0, 0, 1};
  glm::vec2 wide_axis{1, 0};  // of alpha.x, in (x, y)
  float weight = 1;
};

/// What an engine's material has.
struct EngineModel {
  int sheen = formulas::kSheenCharlie;
  bool specular = true;  // its dielectric reflectance can be scaled
};

struct EngineFit {
  glm::vec3 base{1};  // factors of base colour; of sheen's colour
  float specular = 1;
  float sheen = 1;
  float sheen_roughness = 0.5f;
  float error = 0;  // relative RMSE over views (to 71 degrees) and lights
};

/// Texels that stand for a period of the cloth: some as fine as the maps, and one as its last mip. Their roughness
/// holds `share` of the spread of the normals, as a set's does for the distance that it is made for.
struct EngineTexels {
  std::vector<EngineTexel> texels;
  glm::vec2 spread{0};  // variances along x and y that are in the roughness
};
EngineTexels engine_texels(const Cloth& cloth, const Maps& maps, float share);
/// That share, for a pixel so wide and threads so far apart: all of it from two threads on.
float spread_share(float footprint_mm, float spacing_mm);
/// Of a pixel a metre away, in a picture of 1080 rows that is 50 degrees high.
inline constexpr float kFootprintMmAtOneMetre = 0.863f;

/// One pair of directions (x along the weft, y along the warp, z out) and what cloth and fitted material send, for a
/// unit of irradiance at right angles: radiance.
struct EngineCheck {
  glm::vec3 view, light, cloth, engine;
};
/// Straight on and at 43, 59, 71 and 79 degrees along warp and weft, lit from 43 degrees.
std::vector<EngineCheck> check_engine(std::span<const EngineTexel> texels, const Cloth& cloth,
                                      const ClothResponse& response, const EngineModel& model, const EngineFit& fit);

/// Deterministic. Sums over views and lights are the measured answer's, channel by channel.
EngineFit fit_engine(std::span<const EngineTexel> texels, const Cloth& cloth, const ClothResponse& response,
                     const EngineModel& model);

}  // namespace weftlight::light
