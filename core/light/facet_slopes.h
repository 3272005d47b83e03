#pragma once
// How the facets of a system are turned: the density of their slopes, in two dimensions. Fibres that twist around a
// thread lean to one side, so slopes along it and across it are not independent, and the density of one times that of
// the other is wider than the highlight.

#include <glm/glm.hpp>
#include <vector>

#include "shaders/interop.h"

namespace weftlight::light {

inline constexpr int kSlopeBins = RESPONSE_SLOPES;  // on each axis, uniform in the slope's angle, -90 to 90 degrees

/// [angle along y][angle along x]: density of the facets' slope angles, micro-slopes included, over the area of the
/// cloth's plane; integral 1. Empty: no facets, density 0.
using FacetSlopes = std::vector<float>;

/// Facets around a normal.
struct FacetsAround {
  float weight = 0;  // area of the cloth's plane that they cover
  glm::vec3 normal{0, 0, 1}, fibre{1, 0, 0};
  glm::vec3 cov{0};  // of their slopes about the normal (xx, xy, yy), x along the fibre
};

/// Repeatable, whatever the number of cores.
FacetSlopes facet_slopes(const std::vector<FacetsAround>& facets);

/// Density at the given slopes, interpolated between bins as a texture unit does.
float density_at(const FacetSlopes& slopes, const glm::vec2& slope);
/// Density (1/sr) of the facets of a system that mirror light from `l` to `v`. fraction: of the coverage.
float closed_form(const FacetSlopes& slopes, float fraction, const glm::vec3& l, const glm::vec3& v);

}  // namespace weftlight::light
