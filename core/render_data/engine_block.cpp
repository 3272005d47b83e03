#include "render_data/engine_block.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <vector>

#include "cloth/maps.h"
#include "light/engine_fit.h"
#include "light/engine_texels.h"
#include "light/measure_response.h"

namespace weftlight::render_data {

using cloth::Linear, cloth::Maps, cloth::MapsSize, cloth::ThreadBody, cloth::bake, cloth::linear_from_srgb;
using design::Lobes;
using light::EngineFit, light::EngineLobe, light::EngineTexels, light::engine_lobes, light::engine_texels,
    light::fit_engine, light::kFitSamples, light::kFootprintMmAtOneMetre, light::kGltfModel, light::measure_response;

namespace {

// Texels of the maps for the far field: across a thread, and limits of the longer side.
constexpr size_t kTexelsAThread = 32, kMinTexels = 512, kMaxTexels = 1024;

constexpr int kLobePixels = 10;  // a side, for the mean of the lobes

/// Mean base colour of a system over the thread's; w: metal.
glm::vec4 mean_body(const Cloth& cloth, const std::vector<ThreadBody>& threads) {
  glm::vec4 sum(0);
  for (const ThreadBody& t : threads) {
    const Lobes& lobes = cloth.yarns[static_cast<size_t>(t.yarn)].lobes;
    const Linear tint = linear_from_srgb(lobes.specular_tint);
    sum += lobes.metallic ? glm::vec4(glm::vec3(tint.r, tint.g, tint.b) * lobes.specular, 1)
                          : glm::vec4(glm::vec3(lobes.body), 0);
  }
  return sum / static_cast<float>(std::max<size_t>(threads.size(), 1));
}

/// Texels are square to a factor of two.
MapsSize size_of(const Cloth& cloth) {
  const size_t threads = std::max(cloth.ends.size(), cloth.picks.size());
  const float most = static_cast<float>(std::clamp(std::bit_ceil(threads * kTexelsAThread), kMinTexels, kMaxTexels));
  const float longer = std::max({cloth.width_mm, cloth.depth_mm, 1e-6f});
  const auto side = [&](float mm) {
    return static_cast<int>(std::exp2(std::round(std::log2(std::max(most * mm / longer, 16.0f)))));
  };
  return {side(cloth.width_mm), side(cloth.depth_mm), 0};
}

}  // namespace

interop::EngineData engine_block(const Cloth& repeat, float weft_fraction) {
  const Maps maps = bake(repeat, size_of(repeat));
  const EngineTexels seen = engine_texels(repeat, maps, kFootprintMmAtOneMetre);
  const EngineFit fit = fit_engine(seen, repeat, measure_response(repeat, maps, kFitSamples), kGltfModel);
  const std::array<EngineLobe, 2> lobes =
      engine_lobes(engine_texels(repeat, maps, kFootprintMmAtOneMetre, kLobePixels), fit.lobe, weft_fraction);
  const auto packed = [](const EngineLobe& l) { return glm::vec4(l.axis, l.roughness, l.strength); };
  return {glm::vec4(fit.base, fit.f90),
          glm::vec4(fit.f0, 0),
          glm::vec4(fit.sheen, fit.sheen_roughness),
          {seen.lean, 0, 0},
          {packed(lobes[0]), packed(lobes[1])},
          {mean_body(repeat, repeat.ends), mean_body(repeat, repeat.picks)}};
}

}  // namespace weftlight::render_data
