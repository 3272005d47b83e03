#pragma once
// The maps of one period brought to the size of a texture: every texel is the mean of what it covers.
// Colour is averaged in linear light and by coverage, normals as unit vectors; the spread of the normals
// that a mean loses is kept as slope covariance beside that of the yarn's own lobe, so that roughness and
// normal always belong together, at the finest level as in every mip below it.

#include <array>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "cloth/maps.h"
#include "texture_set/names.h"

namespace weftlight::texture_set {

/// A texel of the surface. Axes: x along the weft (u), y along the warp (v), z towards the viewer.
struct SurfaceTexel {
  Linear base;         // body colour with grooves; a metal's reflectance
  Linear sheen;        // colour of the fibres that stand off, times their share
  Linear through;      // light from behind, of the body
  float coverage = 0;  // 0 a gap .. 1
  float height_mm = 0;
  float occlusion = 1;
  float metal = 0;
  float sheen_roughness = 0.5f;
  glm::vec3 normal{0, 0, 1};
  glm::vec3 fibre{1, 0, 0};
  glm::vec3 slope_cov{0};  // xx, xy, yy of the micro-slopes about the normal
  uint32_t thread = 0;     // that covers most
  uint8_t system = 0;      // 0 warp, 1 weft
};

struct Surface {
  float width_mm = 0, depth_mm = 0;
  Plane<SurfaceTexel> texels;
  // One plane an azimuth, as in Maps: mean and standard deviation of the sine of the horizon.
  std::vector<Plane<float>> horizon_mean, horizon_spread;
  float low_mm = 0, high_mm = 1;  // of the whole face, heights
  float smoothness = 0.5f;        // of the whole face, mean
};

/// Means over blocks of texels; the sizes of `maps` are multiples of `width` and `height`.
Surface make_surface(const Cloth& cloth, const Maps& maps, int width, int height, int threads = 0);

/// The next mip: half as many texels a side (at least 1). Sizes are powers of two.
Surface half_of(const Surface& fine, int threads = 0);

/// One texel that stands for several equally large ones.
SurfaceTexel merged(std::span<const SurfaceTexel> parts);

/// GGX alphas of a texel and the direction, in (x, y), of the wider one.
///
/// A Gaussian of slopes of variance s^2 is Beckmann's distribution of alpha = sqrt(2) s; GGX of the same
/// alpha has the same peak, 1 / (pi alpha^2). Based on: Walter, Marschner, Li, Torrance, Microfacet Models
/// for Refraction through Rough Surfaces, 2007; variances add: Olano, Baker, LEAN Mapping, 2010.
struct GgxAlphas {
  float wide = 1, narrow = 1;  // 0..1
  std::array<float, 2> wide_axis{1, 0};
};
GgxAlphas ggx_alphas(const SurfaceTexel& texel);
/// Alphas along and across the texel's fibre.
std::array<float, 2> ggx_along_across(const SurfaceTexel& texel);

}  // namespace weftlight::texture_set
