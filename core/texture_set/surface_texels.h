#pragma once
// The maps of one period, filtered to the size of a texture: every texel is the mean of its area. Colour is averaged in
// linear light and by coverage, normals as unit vectors. The variance of the normals that a mean loses is added to the
// slope covariance of the yarn's lobe, so that normal and roughness belong together at every mip level.

#include <array>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "cloth/maps.h"

namespace weftlight::texture_set {

using cloth::Cloth, cloth::Linear, cloth::Maps, cloth::Plane;

/// A texel of the surface. Axes: x along the weft (u), y along the warp (v), z towards the viewer.
struct SurfaceTexel {
  Linear base;         // diffuse colour with grooves; of a metal the reflectance
  Linear sheen;        // colour of the fuzz times its coverage
  Linear transmitted;  // diffuse transmission
  float coverage = 0;  // 0: a gap
  float height_mm = 0;
  float occlusion = 1;
  float metal = 0;
  float sheen_roughness = 0.5f;
  glm::vec3 normal{0, 0, 1};
  glm::vec3 fibre{1, 0, 0};
  glm::vec3 slope_cov{0};  // xx, xy, yy of the micro-slopes about the normal
  uint32_t thread = 0;     // the thread with the largest coverage
  uint8_t system = 0;      // 0 warp, 1 weft
};

struct SurfaceTexels {
  float width_mm = 0, depth_mm = 0;
  Plane<SurfaceTexel> texels;
  float low_mm = 0, high_mm = 1;  // heights in the whole face
  float smoothness = 0.5f;        // mean of the whole face
  float first_turn = 0;           // where angles of axes begin, in turns (axis_cut)
};

/// Texels without values, of the same face.
SurfaceTexels blank_like(const SurfaceTexels& face, int width, int height);

/// Mean and standard deviation of the sines of the horizons; one plane for each azimuth, as in Maps.
struct HorizonTexels {
  std::vector<Plane<float>> mean, spread;
};
/// Rows [y0, y1) of a face with width x height texels, which divide the size of the planes.
HorizonTexels horizon_rows(const std::vector<Plane<uint8_t>>& planes, int width, int height, int y0, int y1);

/// Averages blocks of map texels; the sizes of `maps` must be multiples of `width` and `height`.
SurfaceTexels make_surface(const Cloth& cloth, const Maps& maps, int width, int height, int threads = 0);

/// The next mip level: half as many texels per side, at least 1. Sizes are powers of two.
SurfaceTexels half_of(const SurfaceTexels& fine, int threads = 0);

/// The average of texels of equal size.
SurfaceTexel merged(std::span<const SurfaceTexel> parts);

/// GGX alphas of a texel and the direction, in (x, y), of the wider one.
///
/// A Gaussian distribution of slopes with variance s^2 is a Beckmann distribution with alpha = sqrt(2) s; GGX with the
/// same alpha has the same peak, 1 / (pi alpha^2). Based on: Walter, Marschner, Li, Torrance, Microfacet Models for
/// Refraction through Rough Surfaces, 2007; variances add: Olano, Baker, LEAN Mapping, 2010.
struct GgxAlphas {
  float wide = 1, narrow = 1;  // 0..1
  std::array<float, 2> wide_axis{1, 0};
};
GgxAlphas ggx_alphas(const SurfaceTexel& texel);
/// An axis has no sense, so that its angle as a number jumps by half a turn somewhere. This is the angle, in turns,
/// 0..0.5, near which the fewest axes of a face lie, by their coverage and how much wider they are.
float axis_cut(std::span<const SurfaceTexel> texels);
/// The angle of a texel's wider axis, in turns, from first_turn to half a turn more.
float axis_turn(const std::array<float, 2>& axis, float first_turn);
/// Alphas along and across the texel's fibre.
std::array<float, 2> ggx_along_across(const SurfaceTexel& texel);

}  // namespace weftlight::texture_set
