#include "light/yarn_lobes.h"

#include <algorithm>
#include <cmath>

namespace weftlight::light {
namespace {

float clamped(float v, float low, float high) { return v >= low ? std::min(v, high) : low; }  // NaN: low

glm::vec3 unit_colour(Linear c) { return {clamped(c.r, 0, 1), clamped(c.g, 0, 1), clamped(c.b, 0, 1)}; }

}  // namespace

formulas::YarnLobes yarn_lobes(const Lobes& lobes, Linear thread_colour) {
  const glm::vec3 colour = unit_colour(thread_colour);
  const float along = clamped(lobes.along_width, 0, 1.0e4f), across = clamped(lobes.across_width, 0, 1.0e4f);
  const float ior = clamped(lobes.ior, 1, 3);
  const float specular = clamped(lobes.specular, 0, 1);
  const float root = (ior - 1) / (ior + 1);  // Fresnel at normal incidence
  formulas::YarnLobes y;
  y.slope_cov = {along * along, 0, across * across};
  y.f90 = specular;
  y.f0 = unit_colour(linear_from_srgb(lobes.specular_tint)) * (specular * root * root);
  glm::vec3 body = colour * clamped(lobes.body, 0, 1);
  if (lobes.metallic) {
    y.f0 = unit_colour(linear_from_srgb(lobes.specular_tint)) * colour * specular;
    body = glm::vec3(0);
  }
  const float through = clamped(lobes.transmission, 0, 1);
  y.body = body * (1 - through);
  y.through = body * through;
  y.fuzz_colour = glm::sqrt(colour);  // light leaves a lone fibre after fewer meetings with the dye
  y.fuzz = clamped(lobes.fuzz, 0, 1);
  const float width = clamped(lobes.fuzz_width, 0.05f, 1);
  y.fuzz_depth = width * width;
  return y;
}

}  // namespace weftlight::light
