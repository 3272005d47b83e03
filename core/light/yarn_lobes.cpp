#include "light/yarn_lobes.h"

#include <algorithm>
#include <cmath>

#include "draft/yarn_fields.h"

namespace weftlight::light {
namespace {

float unit(float v) { return v >= 0 ? std::min(v, 1.0f) : 0; }  // NaN: 0

glm::vec3 unit_colour(Linear c) { return {unit(c.r), unit(c.g), unit(c.b)}; }

}  // namespace

formulas::YarnLobes yarn_lobes(const Lobes& any, Linear thread_colour) {
  const Lobes lobes = clamped(any);
  const glm::vec3 colour = unit_colour(thread_colour);
  const float along = lobes.along_width, across = lobes.across_width, specular = lobes.specular;
  const float root = (lobes.ior - 1) / (lobes.ior + 1);  // Fresnel at normal incidence
  formulas::YarnLobes y;
  y.slope_cov = {along * along, 0, across * across};
  y.f90 = specular;
  y.f0 = unit_colour(linear_from_srgb(lobes.specular_tint)) * (specular * root * root);
  glm::vec3 body = colour * lobes.body;
  if (lobes.metallic) {
    y.f0 = unit_colour(linear_from_srgb(lobes.specular_tint)) * colour * specular;
    body = glm::vec3(0);
  }
  const float through = lobes.transmission;
  y.body = body * (1 - through);
  y.through = body * through;
  y.fuzz_colour = glm::sqrt(colour);  // light leaves a lone fibre after fewer meetings with the dye
  y.fuzz = lobes.fuzz;
  const float width = lobes.fuzz_width;
  y.fuzz_depth = width * width;
  return y;
}

}  // namespace weftlight::light
