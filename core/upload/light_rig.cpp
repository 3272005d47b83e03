// Based on: Ramamoorthi, Hanrahan 2001, "An efficient representation for irradiance environment maps".

#include "upload/light_rig.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <vector>

#include "base/files.h"
#include "base/resources.h"

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

/// Held to what sums of lamps stay finite with.
float number(const nlohmann::json& json) {
  constexpr double kLargest = 1e6;
  return static_cast<float>(std::clamp(json.get<double>(), -kLargest, kLargest));
}

glm::vec3 read_vec(const nlohmann::json& json) { return {number(json.at(0)), number(json.at(1)), number(json.at(2))}; }

}  // namespace

LightRig light_rig_from(std::string_view text, std::string& error) {
  constexpr size_t kMostLamps = 64;
  try {
    const nlohmann::json json = nlohmann::json::parse(text);
    std::vector<Lamp> lamps;
    for (const nlohmann::json& lamp : json.at("lamps")) {
      const glm::vec3 towards = read_vec(lamp.at("towards"));
      const float length = glm::length(towards), sharpness = number(lamp.at("sharpness"));
      if (!(length > 1e-6f) || sharpness < 0 || lamps.size() == kMostLamps) error = "a lamp that cannot be";
      if (!error.empty()) return {};
      lamps.push_back({towards / length, read_vec(lamp.at("color")) * number(lamp.at("strength")), sharpness});
    }
    return {read_vec(json.at("key")), project(lamps)};
  } catch (const nlohmann::json::exception& problem) {
    error = problem.what();
    return {};
  }
}

LightRig load_light_rig(const std::string& name, std::string& error) {
  constexpr uint64_t kMostBytes = uint64_t{1} << 20;
  const std::string path = presets_dir() + "/lights/" + name + ".json";
  const FileBytes file = read_file(path, kMostBytes);
  if (!file.error.empty()) {
    error = path + ": " + file.error + "; set WEFTLIGHT_PRESETS to the folder of presets";
    return {};
  }
  const LightRig rig = light_rig_from(file.bytes, error);
  if (!error.empty()) error = path + ": not a light rig (" + error + "); bring back the shipped file";
  return rig;
}

glm::vec3 sky_radiance(const LightRig& rig, glm::vec3 towards) {
  const std::array<float, 9> basis = harmonics(towards);
  glm::vec3 sum{0};
  for (size_t k = 0; k < basis.size(); ++k) sum += rig.sky[k] * basis[k];
  return glm::max(sum, glm::vec3(0));
}

}  // namespace weftlight::upload
