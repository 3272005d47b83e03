#include "reference/fibre_dye.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/type_ptr.hpp>

#include "base/loops.h"
#include "light/measure_response.h"
#include "light/thread_samples.h"
#include "light/yarn_lobes.h"
#include "reference/fibre_trace.h"
#include "reference/sampling.h"

namespace weftlight::reference {
namespace {

constexpr float kPalest = 1e-4f, kDeepest = 10, kAll = 1000;  // absorption of a radius: steps of the curve, and all
constexpr int kJobs = 32, kPathsOfAJob = 256;
constexpr int kMinPaths = 200;                           // on a yarn, for a curve of its own
constexpr size_t kTraces = (DyeCurve::kDepths + 1) / 3;  // three depths in each, as the channels of a colour
static_assert(kTraces * 3 == DyeCurve::kDepths + 1);

/// What came back from a yarn's fibres, for each depth; the last is that of kAll.
struct Tally {
  std::array<double, kTraces * 3> returned{};
  int paths = 0;
  void add(const Tally& other) {
    for (size_t i = 0; i < returned.size(); ++i) returned[i] += other.returned[i];
    paths += other.paths;
  }
  DyeCurve curve() const {
    std::array<float, DyeCurve::kDepths> of{};
    const double count = std::max(paths, 1);
    for (size_t i = 0; i < of.size(); ++i) of[i] = static_cast<float>(returned[i] / count);
    return {of, static_cast<float>(returned.back() / count)};
  }
};

float depth_or_all(size_t step) { return step < DyeCurve::kDepths ? dye_depth(step) : kAll; }

/// The part of one job, by yarn.
std::vector<Tally> trace_part(const FibreScene& fibres, glm::vec2 low, glm::vec2 high, int job) {
  std::vector<Tally> by_yarn(fibres.cloth().yarns.size());
  Surroundings white;
  white.light_irradiance = glm::vec3(0);
  white.sky = [](glm::vec3 towards) { return glm::vec3(towards.z > 0 ? 1.0f : 0.0f); };
  std::vector<FibreTracer> tracers;
  for (size_t k = 0; k < kTraces; ++k)
    tracers.emplace_back(fibres, glm::vec3(depth_or_all(3 * k), depth_or_all(3 * k + 1), depth_or_all(3 * k + 2)));
  RandomStream random(static_cast<uint64_t>(job) + 1);
  const float away = 2 * (fibres.z_max() - fibres.z_min());
  for (int i = 0; i < kPathsOfAJob; ++i) {
    const glm::vec2 at = low + (high - low) * pixel_sample(job * kPathsOfAJob + i, glm::vec2(0.5f));
    const glm::vec3 view = cosine_direction({0, 0, 1}, random);
    const glm::vec3 from = glm::vec3(at, 0) + view * (away / std::max(view.z, 0.05f));
    FibreHit hit;
    if (!fibres.intersect(from, -view, 0, hit) || hit.optics.metal.x > 0) continue;
    Tally& tally = by_yarn[hit.yarn];
    ++tally.paths;
    for (size_t k = 0; k < kTraces; ++k) {
      const glm::vec3 light = tracers[k].trace(from, -view, 0, white, random).radiance;
      for (int c = 0; c < 3; ++c) tally.returned[3 * k + static_cast<size_t>(c)] += static_cast<double>(light[c]);
    }
  }
  return by_yarn;
}

}  // namespace

float dye_depth(size_t step) {
  if (step == 0) return 0;
  const float along = static_cast<float>(step - 1) / static_cast<float>(DyeCurve::kDepths - 2);
  return kPalest * std::pow(kDeepest / kPalest, along);
}

DyeCurve::DyeCurve(const std::array<float, kDepths>& returned, float mirrored) : mirrored_(mirrored) {
  float above = 1;
  for (size_t i = 0; i < kDepths; ++i)
    body_[i] = above = std::clamp((returned[i] - mirrored) / std::max(1 - mirrored, 1e-3f), 0.0f, above);
}

// Between the steps the root of the absorption is linear in the logarithm of the colour, as in dense hair (Chiang et
// al. 2016, section 4.2).
float DyeCurve::absorption(float reflectance) const {
  constexpr float kBlack = 1e-4f;
  const float wanted = std::max((reflectance - mirrored_) / std::max(1 - mirrored_, 1e-3f), kBlack);
  if (wanted >= body_.front()) return 0;
  for (size_t i = 1; i < kDepths; ++i) {
    if (wanted < body_[i]) continue;
    const float a = std::log(std::max(body_[i - 1], kBlack)), b = std::log(std::max(body_[i], kBlack));
    const float part = a - b > 1e-6f ? std::clamp((a - std::log(wanted)) / (a - b), 0.0f, 1.0f) : 1.0f;
    const float root = std::lerp(std::sqrt(dye_depth(i - 1)), std::sqrt(dye_depth(i)), part);
    return root * root;
  }
  return dye_depth(kDepths - 1);
}

namespace {

/// Reflectance of one thread system under an even sky, relative to the part of the cloth that it is seen on; views by
/// the light that they take from such a cloth.
glm::vec3 under_even_sky(const light::SystemResponse& system, const formulas::YarnLobes& yarn) {
  static const auto kViews = light::response_views();
  glm::vec3 sum(0);
  float seen = 1e-6f;
  for (size_t v = 0; v < kViews.size(); ++v) {
    const float mu = kViews[v].z, weight = mu * std::sqrt(mu);  // nodes lie evenly by the root of mu
    const glm::vec4 sky = glm::make_vec4(&system.sky[4 * v]);
    const auto radiance = formulas::system_radiance(yarn, glm::vec4(0), 0, 0, sky, {0, 0, 1}, kViews[v]);
    sum += weight * (radiance.diffuse + radiance.glossy), seen += weight * system.seen[v];
  }
  return sum / seen;
}

/// Mean of the channels over that of the threads' own colours: what grooves take.
float groove_of(const light::SystemResponse& system, const std::vector<cloth::ThreadBody>& threads) {
  float own = 0, width = 1e-9f;
  for (const cloth::ThreadBody& t : threads)
    own += light::channel_mean({t.colour.r, t.colour.g, t.colour.b}) * t.width_mm, width += t.width_mm;
  const float whole = own / width;
  return whole > 1e-3f
             ? std::clamp(light::channel_mean({system.colour.r, system.colour.g, system.colour.b}) / whole, 0.2f, 1.0f)
             : 1.0f;
}

}  // namespace

ThreadReflectance::ThreadReflectance(const Cloth& cloth) {
  const light::ClothResponse response = light::measure_response(cloth, light::coarse_maps(cloth));
  for (const System system : {System::kWarp, System::kWeft}) {
    const size_t s = system == System::kWarp ? 0 : 1;
    const light::SystemResponse& measured = response.systems[s];
    yarns_[s].resize(cloth.yarns.size());
    if (measured.sky.empty()) continue;
    const float groove = groove_of(measured, s == 0 ? cloth.ends : cloth.picks);
    for (size_t y = 0; y < cloth.yarns.size(); ++y)
      for (size_t i = 0; i < kSteps; ++i) {
        const float root = static_cast<float>(i) / static_cast<float>(kSteps - 1), c = groove * root * root;
        yarns_[s][y][i] = under_even_sky(measured, light::yarn_lobes(cloth.yarns[y].lobes, {c, c, c}));
      }
  }
}

glm::vec3 ThreadReflectance::of(System system, int yarn, glm::vec3 colour) const {
  const ByColour& at = yarns_[system == System::kWarp ? 0 : 1][static_cast<size_t>(yarn)];
  glm::vec3 out;
  for (int c = 0; c < 3; ++c) {
    const float along = std::sqrt(std::clamp(colour[c], 0.0f, 1.0f)) * static_cast<float>(kSteps - 1);
    const size_t i = std::min(static_cast<size_t>(along), kSteps - 2);
    out[c] = std::lerp(at[i][c], at[i + 1][c], along - static_cast<float>(i));
  }
  return out;
}

std::vector<DyeCurve> measure_dyes(const FibreScene& fibres, glm::vec2 low_mm, glm::vec2 high_mm) {
  std::vector<std::vector<Tally>> parts(kJobs);
  base::for_each_job(kJobs,
                     [&](int job) { parts[static_cast<size_t>(job)] = trace_part(fibres, low_mm, high_mm, job); });
  const size_t yarns = fibres.cloth().yarns.size();
  std::vector<Tally> by_yarn(yarns);
  Tally all;
  for (const std::vector<Tally>& part : parts)
    for (size_t y = 0; y < yarns; ++y) by_yarn[y].add(part[y]), all.add(part[y]);
  std::vector<DyeCurve> out;
  for (const Tally& tally : by_yarn) out.push_back((tally.paths >= kMinPaths ? tally : all).curve());
  return out;
}

}  // namespace weftlight::reference
