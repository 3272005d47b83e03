#include "light/cloth_sky.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/type_ptr.hpp>
#include <numbers>

#include "base/loops.h"
#include "light/yarn_lobes.h"

namespace weftlight::light {
namespace {

constexpr float kPi = std::numbers::pi_v<float>;
// Lights of equal parts of the hemisphere. Highlights are narrower than the nodes of the tables lie apart; between them
// the closed form holds.
constexpr int kRings = 20, kTurns = 40;
constexpr float kPart = 2 * kPi / (kRings * kTurns);  // sr

struct SkyLight {
  glm::vec3 towards;
  std::array<size_t, 4> node;
  std::array<float, 4> weight;
};

std::vector<SkyLight> sky_lights() {
  std::vector<SkyLight> out;
  for (int k = 0; k < kRings * kTurns; ++k) {
    const float z = (static_cast<float>(k / kTurns) + 0.5f) / kRings, r = std::sqrt(1 - z * z);
    const float turn = 2 * kPi * (static_cast<float>(k % kTurns) + 0.5f) / kTurns;
    SkyLight light{{r * std::cos(turn), r * std::sin(turn), z}, {}, {}};
    const formulas::vec2 at = formulas::response_coord(light.towards);
    const float x = at.x * kLightAzimuths, low = std::floor(x), across = x - low;
    const float up = std::min(std::floor(at.y), kResponseElevations - 2.0f), above = at.y - up;
    for (size_t c = 0; c < 4; ++c) {
      const bool next = c & 1, higher = c & 2;
      light.node[c] =
          (static_cast<size_t>(up) + higher) * kLightAzimuths + (static_cast<size_t>(low) + next) % kLightAzimuths;
      light.weight[c] = (next ? across : 1 - across) * (higher ? above : 1 - above);
    }
    out.push_back(light);
  }
  return out;
}

/// All that one view is sent: times its direction, and it.
struct SentSky {
  glm::vec4 soft{0}, glossy{0};
};

void add_system(SentSky& sent, SystemResponse& system, const formulas::YarnLobes& yarn,
                const std::vector<SkyLight>& lights, size_t view, const glm::vec3& v) {
  const float hair = yarn.fuzz > 0 ? yarn.fuzz_colour.g : yarn.f0.g / std::max(yarn.f90, 1e-3f);
  glm::vec4 sum(0);
  for (const SkyLight& light : lights) {
    glm::vec4 broad(0);
    for (size_t c = 0; c < 4; ++c)
      broad += light.weight[c] * glm::make_vec4(&system.broad[4 * (view * kResponseLights + light.node[c])]);
    const float mirror =
        broad.y * (closed_form(system.slopes, system.share, light.towards, v) + formulas::kUnseenFacets);
    const float rising = formulas::pile_grazing(yarn.pile, std::max(1 - 0.5f * glm::length(light.towards + v), 0.0f));
    sum += glm::vec4(broad.x, broad.z, mirror, mirror * rising);
    const glm::vec4 from(light.towards, 1);
    sent.soft += (broad.x * yarn.body.g + broad.z * hair) * from;
    sent.glossy += mirror * (yarn.f0.g + (yarn.f90 - yarn.f0.g) * rising) * from;
  }
  for (int c = 0; c < 4; ++c) system.sky[4 * view + static_cast<size_t>(c)] = kPart * sum[c];
}

}  // namespace

void take_sky(ClothResponse& response, const Cloth& cloth) {
  const std::vector<SkyLight> lights = sky_lights();
  const std::array<glm::vec3, kResponseViews> views = response_views();
  std::array<formulas::YarnLobes, 2> yarns;
  for (size_t s = 0; s < 2; ++s) {
    const Linear& c = response.systems[s].colour;
    yarns[s] = formulas::yarn_of(mean_yarn(cloth, s == 0 ? cloth.ends : cloth.picks), {c.r, c.g, c.b});
  }
  for_each_job(kResponseViews, [&](int i) {
    const size_t view = static_cast<size_t>(i);
    SentSky sent;
    for (size_t s = 0; s < 2; ++s) add_system(sent, response.systems[s], yarns[s], lights, view, views[view]);
    if (sent.soft.w > 0) response.sky_from[view][0] = glm::vec3(sent.soft) / sent.soft.w;
    if (sent.glossy.w > 0) response.sky_from[view][1] = glm::vec3(sent.glossy) / sent.glossy.w;
  });
}

}  // namespace weftlight::light
