#pragma once
// How different two pictures look side by side, 0 (alike) to 1: FLIP for pictures of low dynamic range.
//
// Based on: Andersson, Nilsson, Akenine-Moller, Oskarsson, Astrom, Fairchild 2020 (FLIP: a difference evaluator for
//   alternating images), its filters, exponents and constants.

#include <glm/glm.hpp>
#include <span>

namespace weftlight::chart {

/// A desktop screen: 0.7 m away, 0.7 m wide, 3,840 pixels.
inline constexpr double kPixelsADegree = 67.0206;

/// Mean over all pixels. Linear light, display-referred: held to 0..1. Both hold width x height pixels.
double flip_error(std::span<const glm::vec3> picture, std::span<const glm::vec3> truth, int width, int height,
                  double pixels_a_degree = kPixelsADegree);

}  // namespace weftlight::chart
