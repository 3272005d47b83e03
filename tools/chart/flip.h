#pragma once
// The perceived difference of two pictures, 0 (equal) to 1: FLIP for low dynamic range.
//
// Based on: Andersson, Nilsson, Akenine-Moller, Oskarsson, Astrom, Fairchild 2020 (FLIP: a difference evaluator for
//   alternating images), its filters, exponents and constants.

#include <glm/glm.hpp>
#include <span>

namespace weftlight::chart {

/// A desktop screen: 0.7 m away, 0.7 m wide, 3,840 pixels.
inline constexpr double kPixelsPerDegree = 67.0206;

/// Mean over all pixels. Linear display-referred light, clamped to 0..1. Both hold width x height pixels.
double flip_error(std::span<const glm::vec3> picture, std::span<const glm::vec3> truth, int width, int height,
                  double pixels_per_degree = kPixelsPerDegree);

}  // namespace weftlight::chart
