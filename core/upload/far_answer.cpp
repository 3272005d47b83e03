#include "upload/far_answer.h"

#include <algorithm>
#include <cmath>

#include "light/formulas.h"
#include "upload/cloth_block.h"

namespace weftlight::upload {
namespace {

// Means need no fine maps: texels across a thread, and along a side at the most.
constexpr size_t kTexelsPerThread = 16;
constexpr size_t kMostTexels = 768;
constexpr size_t kLeastTexels = 128;

int texels_for(size_t threads) {
  return static_cast<int>(std::clamp(threads * kTexelsPerThread, kLeastTexels, kMostTexels));
}

/// Nodes before and after a direction on one axis of the grid, and the share of the second.
struct Nodes {
  size_t low, high;
  float share;
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

/// As response_at() of shaders/rung_repeat.glsl reads it: between the nodes of light and view.
glm::vec4 broad_at(const SystemResponse& system, const glm::vec3& light, const glm::vec3& view) {
  const formulas::vec2 i = formulas::response_coord(light), o = formulas::response_coord(view);
  const Nodes turn = on_circle(o.x, kViewAzimuths), tilt = on_line(o.y, kResponseElevations);
  const Nodes light_turn = on_circle(i.x, kLightAzimuths), light_tilt = on_line(i.y, kResponseElevations);
  glm::vec4 sum(0);
  for (int corner = 0; corner < 16; ++corner) {
    const auto pick = [&](const Nodes& n, int bit, float& weight) {
      const bool second = corner >> bit & 1;
      weight *= second ? n.share : 1 - n.share;
      return second ? n.high : n.low;
    };
    float weight = 1;
    const size_t v = pick(tilt, 0, weight) * kViewAzimuths + pick(turn, 1, weight);
    const size_t l = pick(light_tilt, 2, weight) * kLightAzimuths + pick(light_turn, 3, weight);
    const float* at = &system.broad[4 * (v * kResponseLights + l)];
    sum += weight * glm::vec4(at[0], at[1], at[2], at[3]);
  }
  return sum;
}

float density_at(const std::array<float, kSlopeBins>& bins, float slope) {
  const float at = std::clamp(formulas::slope_coord(slope) * kSlopeBins - 0.5f, 0.0f, kSlopeBins - 1.0f);
  const Nodes n = on_line(at, kSlopeBins);
  return bins[n.low] + (bins[n.high] - bins[n.low]) * n.share;
}

}  // namespace

FarAnswer far_answer(const Cloth& cloth, int samples) {
  FarAnswer answer;
  if (cloth.ends.empty() || cloth.picks.empty()) return answer;
  const Maps maps = bake(cloth, {texels_for(cloth.ends.size()), texels_for(cloth.picks.size()), 0});
  const FaceInput face{cloth, maps};
  answer.numbers = cloth_block(face, face);
  answer.response = cloth_response(cloth, maps, samples);
  for (size_t s = 0; s < 2; ++s) {
    const Linear& c = answer.response.systems[s].colour;
    answer.numbers.systems[s].color = {c.r, c.g, c.b, 0};
    answer.numbers.systems[s].share = answer.response.systems[s].share;
  }
  return answer;
}

glm::vec3 radiance_from_afar(const FarAnswer& answer, const glm::vec3& light, const glm::vec3& view) {
  const interop::ClothData& numbers = answer.numbers;
  if (answer.response.systems[0].broad.empty() || view.z <= 0) return glm::vec3(0);
  const formulas::vec2 h = formulas::half_slopes(light, view);
  glm::vec3 sum(0);
  for (size_t s = 0; s < 2; ++s) {
    const interop::SystemData& data = numbers.systems[s];
    const SystemResponse& system = answer.response.systems[s];
    const formulas::YarnLobes yarn = formulas::yarn_of(data.yarn, glm::vec3(data.color.x, data.color.y, data.color.z));
    const formulas::vec2 slopes(density_at(system.slopes[0], h.x), density_at(system.slopes[1], h.y));
    sum += formulas::system_answer(yarn, broad_at(system, light, view), slopes, data.share, 0, light, view).key;
  }
  if (numbers.open < 0.5f) return sum;
  const float cover = std::min(numbers.systems[0].coverage + numbers.systems[1].coverage, 1.0f);
  return sum * formulas::coverage_by_view(cover, {numbers.gap_u_mm, numbers.gap_v_mm}, numbers.rim_mm, view);
}

}  // namespace weftlight::upload
