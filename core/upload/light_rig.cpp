// Based on: Ramamoorthi, Hanrahan 2001, "An efficient representation for irradiance environment maps".

#include "upload/light_rig.h"

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <vector>

#include "files/files.h"

namespace weftlight::upload {
namespace {

struct Lamp {
  glm::vec3 towards{0, 1, 0}, color{1};
  float sharpness = 1;  // of exp(sharpness (cos - 1)); 1 fills half the sky, 20 is a soft box
};

std::array<float, 9> harmonics(glm::vec3 d) {
  return {0.282095f,
          0.488603f * d.y,
          0.488603f * d.z,
          0.488603f * d.x,
          1.092548f * d.x * d.y,
          1.092548f * d.y * d.z,
          0.315392f * (3 * d.z * d.z - 1),
          1.092548f * d.x * d.z,
          0.546274f * (d.x * d.x - d.y * d.y)};
}

std::array<glm::vec3, 9> project(const std::vector<Lamp>& lamps) {
  std::array<glm::vec3, 9> sum{};
  constexpr int kSamples = 8192;  // a spiral over the sphere: enough for lamps of sharpness 60
  for (int i = 0; i < kSamples; ++i) {
    const float y = 1 - 2 * (static_cast<float>(i) + 0.5f) / kSamples;
    const float a = 2.39996323f * static_cast<float>(i), r = std::sqrt(std::max(0.0f, 1 - y * y));
    const glm::vec3 d{r * std::cos(a), y, r * std::sin(a)};
    glm::vec3 radiance{0};
    for (const Lamp& lamp : lamps) radiance += lamp.color * std::exp(lamp.sharpness * (glm::dot(d, lamp.towards) - 1));
    const std::array<float, 9> basis = harmonics(d);
    for (size_t k = 0; k < 9; ++k) sum[k] += radiance * (basis[k] * 4 * 3.14159265f / kSamples);
  }
  return sum;
}

glm::vec3 read_vec(const nlohmann::json& json) {
  return {json.at(0).get<float>(), json.at(1).get<float>(), json.at(2).get<float>()};
}

}  // namespace

LightRig load_light_rig(const std::string& name, std::string& error) {
  const std::string path = presets_dir() + "/lights/" + name + ".json";
  std::ifstream in(path);
  if (!in) {
    error = path + ": light rig missing; set WEFTLIGHT_PRESETS to the folder of presets";
    return {};
  }
  try {
    const nlohmann::json json = nlohmann::json::parse(in);
    std::vector<Lamp> lamps;
    for (const nlohmann::json& lamp : json.at("lamps")) {
      lamps.push_back({glm::normalize(read_vec(lamp.at("towards"))),
                       read_vec(lamp.at("color")) * lamp.at("strength").get<float>(),
                       lamp.at("sharpness").get<float>()});
    }
    return {read_vec(json.at("key")), project(lamps)};
  } catch (const nlohmann::json::exception& problem) {
    error = path + ": not a light rig (" + problem.what() + "); bring back the shipped file";
    return {};
  }
}

glm::vec3 sky_radiance(const LightRig& rig, glm::vec3 towards) {
  const std::array<float, 9> basis = harmonics(towards);
  glm::vec3 sum{0};
  for (size_t k = 0; k < basis.size(); ++k) sum += rig.sky[k] * basis[k];
  return glm::max(sum, glm::vec3(0));
}

}  // namespace weftlight::upload
