#include "render_data/far_field.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/type_ptr.hpp>

#include "light/formulas.h"
#include "render_data/cloth_block.h"

namespace weftlight::render_data {

using cloth::Linear, cloth::Maps;
using light::SystemResponse, light::ViewNodes, light::coarse_maps, light::density_at, light::measure_response,
    light::response_at, light::view_nodes;

FarField far_field(const Cloth& cloth, int samples) {
  FarField field;
  if (cloth.ends.empty() || cloth.picks.empty()) return field;
  const Maps maps = coarse_maps(cloth);
  const FaceInput face{cloth, maps};
  field.numbers = cloth_block(face, face);
  field.response = measure_response(cloth, maps, samples);
  for (size_t s = 0; s < 2; ++s) {
    const Linear& c = field.response.systems[s].colour;
    field.numbers.systems[s].color = {c.r, c.g, c.b, 0};
    field.numbers.systems[s].fraction = field.response.systems[s].fraction;
  }
  return field;
}

namespace {

formulas::YarnLobes yarn_of(const interop::SystemData& data) {
  return formulas::yarn_of(data.yarn, glm::vec3(data.color));
}

float cover_along(const interop::ClothData& numbers, const glm::vec3& view) {
  if (numbers.open < 0.5f) return 1;
  const float cover = std::min(numbers.systems[0].coverage + numbers.systems[1].coverage, 1.0f);
  return formulas::coverage_by_view(cover, {numbers.gap_u_mm, numbers.gap_v_mm}, numbers.rim_mm, view);
}

}  // namespace

glm::vec3 far_field_radiance(const FarField& field, const glm::vec3& light, const glm::vec3& view) {
  if (field.response.systems[0].reflected.empty() || view.z <= 0) return glm::vec3(0);
  const formulas::vec2 h = formulas::half_slopes(light, view);
  glm::vec3 sum(0);
  for (size_t s = 0; s < 2; ++s) {
    const interop::SystemData& data = field.numbers.systems[s];
    const SystemResponse& system = field.response.systems[s];
    sum += formulas::system_radiance(yarn_of(data), response_at(system, light, view), density_at(system.slopes, h),
                                     data.fraction, glm::vec4(0), light, view)
               .key;
  }
  return sum * cover_along(field.numbers, view);
}

glm::vec3 far_field_sky_radiance(const FarField& field, const glm::vec3& view, float even, const glm::vec3& rise) {
  if (field.response.systems[0].sky.empty() || view.z <= 0) return glm::vec3(0);
  const ViewNodes views = view_nodes(view);
  glm::vec3 diffuse(0), glossy(0), from_diffuse(0), from_glossy(0);
  for (size_t k = 0; k < 4; ++k) {
    from_diffuse += views.weight[k] * field.response.sky_from[views.at[k]][0];
    from_glossy += views.weight[k] * field.response.sky_from[views.at[k]][1];
  }
  for (size_t s = 0; s < 2; ++s) {
    glm::vec4 sky(0);
    for (size_t k = 0; k < 4; ++k)
      sky += views.weight[k] * glm::make_vec4(&field.response.systems[s].sky[4 * views.at[k]]);
    const auto radiance =
        formulas::system_radiance(yarn_of(field.numbers.systems[s]), glm::vec4(0), 0, 0, sky, {0, 0, 1}, view);
    diffuse += radiance.diffuse, glossy += radiance.glossy;
  }
  return (diffuse * (even + glm::dot(rise, from_diffuse)) + glossy * (even + glm::dot(rise, from_glossy))) *
         cover_along(field.numbers, view);
}

}  // namespace weftlight::render_data
