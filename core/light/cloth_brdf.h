#pragma once
// BRDF of a whole cloth from its weave (VRST 2003, section 3.3; shaders/vrst03.glsl): fractions, widths and colours
// come from the cloth, normalisations and the table of g from quadrature.

#include "cloth/cloth.h"
#include "light/formulas.h"
#include "light/tables.h"

namespace weftlight::light {

using cloth::Cloth, cloth::Linear;

struct ClothBrdf {
  formulas::Vrst03 p;  // complete: c_warp, c_weft and mean_hn are set
  Table g;             // over formulas::vrst03_g_coord
};

/// From fractions and widths. The fractions are normalised (both zero: halves), widths clamped to 0.01..4.
ClothBrdf make_cloth_brdf(float f_warp, float f_weft, float sigma_warp, float sigma_weft, Linear warp, Linear weft);

/// From the weave: fractions by the cells of this face. The width of a system's Gaussian is the slope of a thread that
/// climbs over its crossing threads within its mean float, so that long floats shine like satin.
ClothBrdf cloth_brdf(const Cloth& cloth);

/// g(w) from the table; w.z >= 0.
float shadowing(const ClothBrdf& brdf, const glm::vec3& w);

/// BRDF, 1/sr; 0 below the horizon.
glm::vec3 evaluate(const ClothBrdf& brdf, const glm::vec3& wi, const glm::vec3& wo);

}  // namespace weftlight::light
