#pragma once
// A cloth's face as an engine samples the images of its set: encoded values averaged over a pixel's footprint, with the
// facets of what lies in it kept apart, so that a fit may widen or narrow their lobes.

#include <array>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "cloth/maps.h"
#include "light/formulas.h"
#include "light/names.h"

namespace weftlight::light {

/// Covariance (xx, xy, yy) of the micro-slopes of a yarn's facets about their normal, over the axes of the texture.
glm::vec3 facet_covariance(const glm::vec3& normal, const glm::vec3& fibre, const Lobes& lobes);
/// Squares of a fibre's direction along x and y; sum 1.
glm::vec2 grain_of(const glm::vec3& fibre);
/// Facets of all threads in a pixel's footprint, as one lobe.
struct FootprintLobe {
  glm::vec3 covariance{0};  // about the mean normal: that of the facets and the spread of the normals
  glm::vec2 grain{0.5f};    // how the fibres run: means of the squares of their directions' x and y; sum 1
};
/// One place of it; normal and fibre as in the maps, covariance about the normal.
struct LobePart {
  glm::vec3 normal{0, 0, 1};
  glm::vec3 covariance{0};
  glm::vec2 grain{0.5f};
  float weight = 1;
};
FootprintLobe footprint_lobe(std::span<const LobePart> parts);
/// Its covariance, narrowed by a fit: factors of the variances along the fibres and across, as far as they run alike.
glm::vec3 scaled_covariance(const FootprintLobe& lobe, const glm::vec2& scale);

/// GGX's alphas for it, 0..1, the wider first, and the wider one's direction in (x, y): alpha = sqrt(2 variance).
struct FacetAlphas {
  glm::vec2 alpha{1, 1};
  glm::vec2 axis{1, 0};
};
FacetAlphas facet_alphas(const glm::vec3& covariance);

/// One texel of the finest level.
struct EngineFacet {
  glm::vec3 covariance{0};
  bool weft = false;
  float weight = 1;  // coverage
};

/// What a pixel of an engine gets: means over its footprint. Its alphas come from the facets.
struct EngineTexel {
  formulas::EngineMaterial material{};
  glm::vec3 normal{0, 0, 1};
  float weight = 1;
  FootprintLobe lobe;  // where `share` is not 0
  std::vector<EngineFacet> facets;
};

/// A lobe as glTF encodes it, averaged as an engine averages images.
struct EngineLobe {
  glm::vec2 axis{1, 0};  // of the wider alpha
  float roughness = 1;   // root of the narrower alpha
  float strength = 0;    // alpha_wide = mix(alpha_narrow, 1, strength^2)
  glm::vec2 alpha() const;
};
/// share: how far each texel of a set takes the lobe of its footprint for its own.
EngineLobe engine_lobe(const EngineTexel& texel, const glm::vec2& scale, float footprint_weight);

/// Mean of warp and weft.
float thread_spacing_mm(const Cloth& cloth);
/// Side of the square whose facets make that lobe: the footprint, but at least two threads, so that it knows both
/// systems.
float lobe_window_mm(float footprint_mm, float spacing_mm);
/// That share, for a pixel so wide and threads so far apart: all of it from two threads on.
float footprint_weight(float footprint_mm, float spacing_mm);

/// Pixels that stand for a period of the cloth.
struct EngineTexels {
  std::vector<EngineTexel> texels;
  float footprint_weight = 0;
};
inline constexpr int kFitPixels = 4;
/// footprint_mm: a pixel's width; 0: a texel of the maps. `pixels`: so many a side.
EngineTexels engine_texels(const Cloth& cloth, const Maps& maps, float footprint_mm, int pixels = kFitPixels);
/// A line through the lobes of all pixels, where they hold warp alone and where weft alone; at the cloth's share of
/// weft lies their mean. Between, roughness and strength keep to 0..1; at its ends they need not.
std::array<EngineLobe, 2> engine_lobes(const EngineTexels& texels, const glm::vec2& scale, float weft_fraction);

/// Of a pixel a metre away, in a picture of 1080 rows that is 50 degrees high.
inline constexpr float kFootprintMmAtOneMetre = 0.863f;

}  // namespace weftlight::light
