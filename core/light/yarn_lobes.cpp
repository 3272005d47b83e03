#include "light/yarn_lobes.h"

#include <algorithm>
#include <cmath>

#include "draft/yarn_fields.h"

namespace weftlight::light {
namespace {

float unit(float v) { return v >= 0 ? std::min(v, 1.0f) : 0; }  // NaN: 0

glm::vec3 unit_colour(Linear c) { return {unit(c.r), unit(c.g), unit(c.b)}; }

}  // namespace

interop::YarnData yarn_data(const Lobes& any) {
  const Lobes lobes = clamped(any);
  const Linear tint = linear_from_srgb(lobes.specular_tint);
  const float root = (lobes.ior - 1) / (lobes.ior + 1);  // Fresnel at normal incidence
  interop::YarnData y{};
  y.along_width = lobes.along_width, y.across_width = lobes.across_width;
  y.specular = lobes.specular, y.reflectance = root * root;
  y.body = lobes.body, y.transmission = lobes.transmission;
  y.fuzz = lobes.fuzz, y.fuzz_width = lobes.fuzz_width, y.fuzz_depth = lobes.fuzz_width * lobes.fuzz_width;
  y.tint = {tint.r, tint.g, tint.b, lobes.metallic ? 1.0f : 0.0f};
  return y;
}

formulas::YarnLobes yarn_lobes(const Lobes& lobes, Linear thread_colour) {
  return formulas::yarn_of(yarn_data(lobes), unit_colour(thread_colour));
}

}  // namespace weftlight::light
