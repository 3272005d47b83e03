#include "light/cloth_response.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/type_ptr.hpp>

#include "light/formulas.h"

namespace weftlight::light {

namespace {

/// Neighbouring nodes of a direction on one axis of the grid, and the weight of the second.
struct Nodes {
  size_t low, high;
  float fraction;
};

Nodes on_circle(float at, int count) {
  const float x = at * static_cast<float>(count), whole = std::floor(x);
  const int low = static_cast<int>(whole) % count;
  return {static_cast<size_t>(low), static_cast<size_t>((low + 1) % count), x - whole};
}

Nodes on_line(float at, int count) {
  const int low = std::clamp(static_cast<int>(at), 0, count - 2);
  return {static_cast<size_t>(low), static_cast<size_t>(low + 1), at - static_cast<float>(low)};
}

}  // namespace

ViewNodes view_nodes(const glm::vec3& view) {
  const formulas::vec2 o = formulas::response_coord(view);
  const Nodes turn = on_circle(o.x, kViewAzimuths), tilt = on_line(o.y, kResponseElevations);
  const size_t low = tilt.low * kViewAzimuths, high = tilt.high * kViewAzimuths;
  const float a = turn.fraction, e = tilt.fraction;
  return {{low + turn.low, low + turn.high, high + turn.low, high + turn.high},
          {(1 - e) * (1 - a), (1 - e) * a, e * (1 - a), e * a}};
}

glm::vec4 response_at(const SystemResponse& system, const glm::vec3& light, const glm::vec3& view) {
  const bool before = light.z > 0;
  const formulas::vec2 i = before ? formulas::response_coord(light) : formulas::transmission_coord(light);
  const int azimuths = before ? kLightAzimuths : kTransmissionAzimuths,
            lights = before ? kResponseLights : kTransmissionLights;
  const Nodes turn = on_circle(i.x, azimuths),
              tilt = on_line(i.y, before ? kResponseElevations : kTransmissionElevations);
  const ViewNodes views = view_nodes(view);
  glm::vec4 sum(0);
  for (size_t corner = 0; corner < 16; ++corner) {
    const bool turned = corner >> 2 & 1, tilted = corner >> 3 & 1;
    const float weight = views.weight[corner & 3] * (turned ? turn.fraction : 1 - turn.fraction) *
                         (tilted ? tilt.fraction : 1 - tilt.fraction);
    const size_t node = views.at[corner & 3] * static_cast<size_t>(lights) +
                        (tilted ? tilt.high : tilt.low) * static_cast<size_t>(azimuths) +
                        (turned ? turn.high : turn.low);
    sum += weight * glm::make_vec4(&(before ? system.reflected : system.transmitted)[4 * node]);
  }
  if (before) sum.y = formulas::mirror_of(sum.y);
  return sum;
}

}  // namespace weftlight::light
