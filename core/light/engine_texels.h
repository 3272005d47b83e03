#pragma once
// A cloth's face as an engine samples its textures: encoded values averaged over a pixel's footprint, with the facets
// kept separate so that a fit can change the width of their lobes.

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "cloth/maps.h"
#include "light/formulas.h"

namespace weftlight::light {

using cloth::Cloth, cloth::Maps;
using design::Lobes;

/// Covariance of the micro-slopes of a yarn's facets about their normal, on the axes of the texture. By component,
/// since compilers vectorise no loop with a glm::vec3. along2, across2: squared widths of its lobe; (nx, ny, nz): the
/// normal, (fx, fy, fz): the fibre.
struct FacetCovariance {
  float xx = 0, xy = 0, yy = 0;
};
inline FacetCovariance facet_covariance(float nx, float ny, float nz, float fx, float fy, float fz, float along2,
                                        float across2) {
  // The tangent frame of the normal: t along the texture's x, seen from above.
  const float sx = 1.0f - nx * nx, sy = 0.0f - ny * nx, sz = 0.0f - nz * nx, size2 = sx * sx + sy * sy + sz * sz;
  const bool upright = size2 > 1e-12f;
  const float over = 1.0f / std::sqrt(size2), ux = sx * over, uy = sy * over, uz = sz * over;
  const float tx = upright ? ux : 0.0f, ty = upright ? uy : 0.0f, tz = upright ? uz : -1.0f;
  const float bx = ny * tz - ty * nz, by = nz * tx - tz * nx, bz = nx * ty - tx * ny;
  const float x = fx * tx + fy * ty + fz * tz, y = fx * bx + fy * by + fz * bz;
  const float length2 = std::max(x * x + y * y, 1e-12f), along = along2 / length2, across = across2 / length2;
  return {along * x * x + across * y * y, (along - across) * x * y, along * y * y + across * x * x};
}
/// Covariance as xx, xy, yy.
inline glm::vec3 facet_covariance(const glm::vec3& normal, const glm::vec3& fibre, const Lobes& lobes) {
  const auto [xx, xy, yy] =
      facet_covariance(normal.x, normal.y, normal.z, fibre.x, fibre.y, fibre.z, lobes.along_width * lobes.along_width,
                       lobes.across_width * lobes.across_width);
  return {xx, xy, yy};
}
/// Squared x and y of a fibre's direction; sum 1.
glm::vec2 grain_of(const glm::vec3& fibre);
/// All facets in a pixel's footprint as one lobe.
struct FootprintLobe {
  glm::vec3 covariance{0};  // about the mean normal: of the facets plus the spread of the normals
  glm::vec2 grain{0.5f};    // means of the squared x and y of the fibres' directions; sum 1
};
/// One sample of a lobe; normal and fibre as in the maps, covariance about the normal.
struct LobePart {
  glm::vec3 normal{0, 0, 1};
  glm::vec3 covariance{0};
  glm::vec2 grain{0.5f};
  float weight = 1;
};
FootprintLobe footprint_lobe(std::span<const LobePart> parts);
/// Factors of a footprint's variances.
struct LobeScale {
  glm::vec2 fibre{1, 1};  // along and across the fibres, as far as these are parallel
  float weft = 1;         // along the weft; along the warp 1 / weft
};
glm::vec3 scaled_covariance(const FootprintLobe& lobe, const LobeScale& scale);

/// Its GGX alphas, 0..1, the wider first, and the direction of the wider axis in (x, y): alpha = sqrt(2 variance).
struct FacetAlphas {
  glm::vec2 alpha{1, 1};
  glm::vec2 axis{1, 0};
};
FacetAlphas facet_alphas(const glm::vec3& covariance);

/// One texel of the finest level.
struct EngineFacet {
  glm::vec3 covariance{0};
  glm::vec2 grain{0.5f};
  bool weft = false;
  float weight = 1;  // coverage
};

/// Means over the footprint of an engine's pixel. The alphas come from the facets.
struct EngineTexel {
  formulas::EngineMaterial material{};
  glm::vec3 normal{0, 0, 1};
  float weight = 1;
  FootprintLobe lobe;  // only with footprint_weight > 0
  std::vector<EngineFacet> facets;
};

/// A lobe in glTF's encoding, averaged as an engine averages images.
struct EngineLobe {
  glm::vec2 axis{1, 0};  // of the wider alpha
  float roughness = 1;   // square root of the narrower alpha
  float strength = 0;    // alpha_wide = mix(alpha_narrow, 1, strength^2)
  glm::vec2 alpha() const;
};
/// footprint_weight: weight of the footprint's lobe against that of the texel itself.
EngineLobe engine_lobe(const EngineTexel& texel, const LobeScale& scale, float footprint_weight);

/// Mean spacing over warp and weft.
float thread_spacing_mm(const Cloth& cloth);
/// Side of the square whose facets make up the lobe: the footprint, but at least two threads, so that both systems are
/// in it.
float lobe_window_mm(float footprint_mm, float spacing_mm);
/// Weight of the footprint's lobe by pixel width and thread spacing: 1 from two threads on.
float footprint_weight(float footprint_mm, float spacing_mm);

/// Pixels that represent a period of the cloth.
struct EngineTexels {
  std::vector<EngineTexel> texels;  // their normals are straightened
  glm::vec2 lean{0};                // mean slope of their normals before that
  float footprint_weight = 0;
};
/// The normal with its slope less that of the mean. Floats lean all the same way in a satin, so that the mean of their
/// normals leans, while the cloth's highlight does not.
glm::vec3 straightened(const glm::vec3& normal, const glm::vec2& lean);
/// The normal with its slopes times these factors.
glm::vec3 flattened(const glm::vec3& normal, const glm::vec2& relief);
inline constexpr int kFitPixels = 4;
/// footprint_mm: a pixel's width; 0: one texel of the maps. `pixels`: a side.
EngineTexels engine_texels(const Cloth& cloth, const Maps& maps, float footprint_mm, int pixels = kFitPixels);
/// Linear fit of all pixels' lobes: at warp only and at weft only; at the cloth's own weft fraction lies their mean.
/// Roughness and strength stay within 0..1 between, not necessarily at the ends.
std::array<EngineLobe, 2> engine_lobes(const EngineTexels& texels, const LobeScale& scale, float weft_fraction);

/// Pixel size at one metre, in a picture of 1080 rows with a field of view of 50 degrees.
inline constexpr float kFootprintMmAtOneMetre = 0.863f;

}  // namespace weftlight::light
