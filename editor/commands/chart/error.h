#pragma once
// Distances between pictures in linear light. Error: sqrt(mean |a - b|^2) / sqrt(mean |truth|^2), means over
// pixels and RGB.

#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "commands/chart/names.h"

namespace weftlight::chart {

using Pixels = std::vector<glm::vec3>;

double relative_rmse(std::span<const glm::vec3> picture, std::span<const glm::vec3> truth);

/// The same against a truth known by two independent estimates: the product of the two differences has no
/// share of their noise, so the result is not raised by it. 0 where noise leaves nothing.
double relative_rmse(std::span<const glm::vec3> picture, std::span<const glm::vec3> half,
                     std::span<const glm::vec3> other_half);

/// Noise of the mean of both halves, as a relative RMSE.
double noise_of(std::span<const glm::vec3> half, std::span<const glm::vec3> other_half);

double mean_ratio(std::span<const glm::vec3> picture, std::span<const glm::vec3> truth);
double mean_value(std::span<const glm::vec3> picture);

/// RMS over pixels of the standard deviation of a pixel over the pictures, over the mean of all.
double flicker_of(const std::vector<Pixels>& pans);

/// Means of blocks of nx x ny samples; width and height are whole blocks.
Pixels box_average(std::span<const glm::vec3> samples, int width, int height, int nx, int ny);

}  // namespace weftlight::chart
