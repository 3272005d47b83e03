#pragma once
// Differences between pictures in linear light. Error: sqrt(mean |a - b|^2) / sqrt(mean |truth|^2), means over pixels
// and RGB.

#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace weftlight::chart {

using Pixels = std::vector<glm::vec3>;

double relative_rmse(std::span<const glm::vec3> picture, std::span<const glm::vec3> truth);

/// The same against two independent estimates of the truth: their noise cancels in the product of the two differences.
/// 0 if the noise is larger than the error.
double relative_rmse(std::span<const glm::vec3> picture, std::span<const glm::vec3> half,
                     std::span<const glm::vec3> other_half);

/// Noise of the mean of both halves, as a relative RMSE.
double noise_of(std::span<const glm::vec3> half, std::span<const glm::vec3> other_half);

double mean_ratio(std::span<const glm::vec3> picture, std::span<const glm::vec3> truth);
double mean_value(std::span<const glm::vec3> picture);

/// RMS over pixels of the standard deviation over the pictures, divided by the mean of all.
double flicker_of(const std::vector<Pixels>& pans);

/// Means of blocks of nx x ny samples; width and height are multiples of them.
Pixels box_average(std::span<const glm::vec3> samples, int width, int height, int nx, int ny);

}  // namespace weftlight::chart
