#include "render_data/method_weights.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "light/formulas.h"

namespace weftlight::render_data {

using drape::Mesh, drape::Vec2, drape::Vec3;
using light::Plan, light::expected, light::plan_of;

namespace {

// Of the cloth: simplified folds have a few triangles that are extremely stretched.
constexpr float kSlivers = 0.002f;

/// Square root of a pixel's area on the cloth, as footprint_here() of cloth_fetch.glsl.
float pixel_size(const glm::mat2& cloth_by_pixel) {
  const float area = std::abs(glm::determinant(cloth_by_pixel));
  const float sum = glm::dot(cloth_by_pixel[0], cloth_by_pixel[0]) + glm::dot(cloth_by_pixel[1], cloth_by_pixel[1]);
  const float longest2 = 0.5f * (sum + std::sqrt(std::max(sum * sum - 4 * area * area, 0.0f)));
  return std::sqrt(std::max(area, longest2 / 256));
}

/// Fraction of a triangle's bounding rectangle that lies in the picture, as an estimate for the triangle.
float shown_part(glm::vec2 a, glm::vec2 b, glm::vec2 c, glm::vec2 picture) {
  const glm::vec2 low = glm::min(a, glm::min(b, c)), high = glm::max(a, glm::max(b, c));
  const glm::vec2 shown = glm::max(glm::min(high, picture) - glm::max(low, glm::vec2(0)), glm::vec2(0)),
                  all = high - low;
  return shown.x * shown.y / std::max(all.x * all.y, 1e-6f);
}

/// Extends the visible bounds by the part of a triangle that lies in the picture.
void widen(MethodWeights& weights, const std::array<glm::vec2, 3>& pixel, const std::array<glm::vec2, 3>& uv,
           const glm::mat2& cloth_by_pixel, glm::vec2 picture) {
  glm::vec2 low = glm::min(uv[0], glm::min(uv[1], uv[2])), high = glm::max(uv[0], glm::max(uv[1], uv[2]));
  glm::vec2 picture_low(std::numeric_limits<float>::infinity()), picture_high = -picture_low;
  for (const glm::vec2 corner : {glm::vec2(0), glm::vec2(picture.x, 0), glm::vec2(0, picture.y), picture}) {
    const glm::vec2 at = uv[0] + cloth_by_pixel * (corner - pixel[0]);
    picture_low = glm::min(picture_low, at), picture_high = glm::max(picture_high, at);
  }
  low = glm::max(low, picture_low), high = glm::min(high, picture_high);
  const bool first = weights.visible_high.x <= weights.visible_low.x;
  weights.visible_low = first ? low : glm::min(weights.visible_low, low);
  weights.visible_high = first ? high : glm::max(weights.visible_high, high);
}

constexpr float kBinsAnOctave = 3, kFirstOctave = -8;

size_t bin_of(float yarns) {
  const float bin = (std::log2(std::max(yarns, 1e-6f)) - kFirstOctave) * kBinsAnOctave;
  return static_cast<size_t>(std::clamp(bin, 0.0f, static_cast<float>(kFootprintBins - 1)));
}

}  // namespace

VisiblePart visible_part(const MethodWeights& weights, float spacing_mm) {
  float sum = 0;
  for (size_t k = 0; k < kFootprintBins; ++k) {
    sum += weights.footprints[k];
    if (sum > kSlivers)
      return {weights.visible_low.x, weights.visible_low.y, weights.visible_high.x, weights.visible_high.y,
              footprint_of_bin(k) * spacing_mm};
  }
  return {};
}

float footprint_of_bin(size_t k) { return std::exp2(kFirstOctave + (static_cast<float>(k) + 0.5f) / kBinsAnOctave); }

float expected_ms(const LodTable& lod_table, const MethodWeights& weights, float pixels, const LodDemand& demand) {
  const Plan plan = plan_of(lod_table, demand);
  float ns = 0;
  for (size_t k = 0; k < kFootprintBins; ++k) {
    if (weights.footprints[k] > 0) ns += weights.footprints[k] * expected(lod_table, plan, footprint_of_bin(k)).cost_ns;
  }
  return ns * pixels * 1e-6f;
}

float tolerance_within(const LodTable& lod_table, const MethodWeights& weights, float pixels, float as_measured,
                       float budget_ms) {
  // Bisection in the logarithm: coarser is cheaper.
  float fine = std::log2(kFinestTolerance), coarse = std::log2(kCoarsestTolerance);
  const auto fits = [&](float octave) {
    return expected_ms(lod_table, weights, pixels, {std::exp2(octave)}) * as_measured <= budget_ms;
  };
  if (fits(fine)) return kFinestTolerance;
  for (int k = 0; k < 8; ++k) {
    const float middle = 0.5f * (fine + coarse);
    (fits(middle) ? coarse : fine) = middle;
  }
  return std::exp2(coarse);
}

MethodWeights method_weights(const PreparedMesh& prepared, const Camera& camera, int width, int height,
                             float spacing_mm, const std::array<float, 3>& edges) {
  const Mesh& mesh = prepared.mesh;
  std::vector<glm::vec3> pixel;  // z: 1 where the vertex is in front of the eye
  pixel.reserve(mesh.position_mm.size());
  for (const Vec3& p : mesh.position_mm) {
    const glm::vec4 c = camera.world_to_clip * glm::vec4(p[0], p[1], p[2], 1);
    const float w = std::max(c.w, 1e-6f);
    pixel.push_back({(c.x / w * 0.5f + 0.5f) * static_cast<float>(width),
                     (c.y / w * 0.5f + 0.5f) * static_cast<float>(height), c.w > 0 ? 1.0f : 0.0f});
  }
  MethodWeights weights;
  float all = 0, octaves = 0;
  std::array<float, 4> wanted{};
  const std::vector<uint32_t>& index = prepared.coarse.empty() ? mesh.index : prepared.coarse;
  for (size_t i = 0; i + 2 < index.size(); i += 3) {
    const glm::vec3 &a = pixel[index[i]], &b = pixel[index[i + 1]], &c = pixel[index[i + 2]];
    if (a.z * b.z * c.z <= 0) {
      if (a.z + b.z + c.z > 0) wanted[0] = std::numeric_limits<float>::infinity();  // it passes the eye
      continue;
    }
    const float part = shown_part(a, b, c, {width, height});
    if (part <= 0) continue;
    const Vec2 &ua = mesh.uv_mm[index[i]], &ub = mesh.uv_mm[index[i + 1]], &uc = mesh.uv_mm[index[i + 2]];
    const glm::mat2 on_picture(glm::vec2(b - a), glm::vec2(c - a));
    const float area = std::abs(glm::determinant(on_picture)), on_screen = area * part;
    if (area <= 1e-6f) continue;
    const glm::mat2 on_cloth(ub[0] - ua[0], ub[1] - ua[1], uc[0] - ua[0], uc[1] - ua[1]);
    const glm::mat2 cloth_by_pixel = on_cloth * glm::inverse(on_picture);
    const float yarns = pixel_size(cloth_by_pixel) / std::max(spacing_mm, 1e-6f);
    const auto point = [](const Vec2& uv) { return glm::vec2(uv[0], uv[1]); };
    widen(weights, {glm::vec2(a), glm::vec2(b), glm::vec2(c)}, {point(ua), point(ub), point(uc)}, cloth_by_pixel,
          {width, height});
    const glm::vec4 weight = formulas::lod_weights(yarns, {edges[0], edges[1], edges[2]});
    for (int k = 0; k < 4; ++k) wanted[static_cast<size_t>(k)] += weight[k] > kNegligibleWeight ? on_screen : 0;
    for (int k = 0; k < 4; ++k) weights.of[static_cast<size_t>(k)] += weight[k] * on_screen;
    octaves += std::log2(std::max(yarns, 1e-6f)) * on_screen;
    weights.footprints[bin_of(yarns)] += on_screen;
    all += on_screen;
  }
  for (size_t k = 0; k < 4; ++k) weights.needed[k] = wanted[k] > kSlivers * all;
  if (all <= 0) return weights;
  for (float& s : weights.of) s /= all;
  for (float& s : weights.footprints) s /= all;
  weights.yarns_per_pixel = std::exp2(octaves / all);
  return weights;
}

}  // namespace weftlight::render_data
