#include "light/engine_directions.h"

#include <algorithm>
#include <cmath>

#include "light/yarn_lobes.h"

namespace weftlight::light {

using cloth::Linear;

namespace {

constexpr float kRadians = 0.01745329252f;
constexpr float kFitViews[] = {0, 15, 30, 45, 60, 70, 77};
constexpr float kPlaneViews[] = {0, 30, 60, 75};
constexpr float kCheckViews[] = {79.4162f, 70.9417f, 59.3226f, 42.7186f, 0};  // nodes of the response
constexpr float kCheckLight = 42.7186f;
constexpr int kPlanes = 4;                          // along the weft, between, along the warp, between
constexpr float kLastLight = 80, kLightStep = 10;   // in the plane of the view, both sides of the normal
constexpr float kRingsAround[] = {20, 42, 60, 76};  // of lights out of the planes
constexpr int kAzimuthsAround = 8;
// Weights of squared relative errors of means between the planes of the threads and around, over that of the shape.
constexpr float kBetweenWeight = 1, kAroundWeight = 8;
constexpr float kSteepView = 65, kSteepWeight = 1.1f;
constexpr size_t kLowestNode = 3;  // elevation of 11 degrees

glm::vec3 direction(float from_normal_deg, float azimuth_deg) {
  const float t = from_normal_deg * kRadians, a = azimuth_deg * kRadians;
  return {std::sin(t) * std::cos(a), std::sin(t) * std::sin(a), std::cos(t)};
}

/// Fills fractions of a mean from the solid angle or angle that each of its pairs stands for.
void normalise(EngineDirections& out, const EngineView& mean) {
  float sum = 0;
  for (size_t i = mean.first; i < mean.first + mean.count; ++i) sum += out.pairs[i].fraction;
  for (size_t i = mean.first; i < mean.first + mean.count; ++i) out.pairs[i].fraction /= sum;
}

/// Lights of a plane, from -80 to 80 degrees.
void add_plane_lights(std::vector<glm::vec3>& lights, float azimuth_deg) {
  constexpr int kHalf = static_cast<int>(kLastLight / kLightStep);
  for (int i = -kHalf; i <= kHalf; ++i) lights.push_back(direction(static_cast<float>(i) * kLightStep, azimuth_deg));
}

/// Adds a view with the lights [first, last), each with this part of the mean.
void add_view(EngineDirections& out, const FarRadiance& cloth, EngineView mean, size_t first, size_t last,
              bool by_cosine) {
  mean.first = out.pairs.size(), mean.count = last - first;
  for (size_t l = first; l < last; ++l) {
    const glm::vec3 &light = out.lights[l], &view = out.views[mean.view];
    const float part = by_cosine ? std::sqrt(1 - light.z * light.z) : 1;
    out.pairs.push_back({mean.view, l, cloth.even(light, view), part});
  }
  normalise(out, mean);
  out.means.push_back(mean);
}

}  // namespace

FarRadiance::FarRadiance(const Cloth& cloth, const ClothResponse& response) : response_(response) {
  for (size_t s = 0; s < 2; ++s) {
    const Linear& c = response.systems[s].colour;
    yarns_[s] = formulas::yarn_of(mean_yarn(cloth, s == 0 ? cloth.ends : cloth.picks), {c.r, c.g, c.b});
  }
}

glm::vec3 FarRadiance::at(const glm::vec3& light, const glm::vec3& view) const {
  const glm::vec2 h = formulas::half_slopes(light, view);
  glm::vec3 sum(0);
  for (size_t s = 0; s < 2; ++s) {
    const SystemResponse& system = response_.systems[s];
    sum += formulas::system_radiance(yarns_[s], response_at(system, light, view), density_at(system.slopes, h),
                                     system.fraction, glm::vec4(0), light, view)
               .key;
  }
  return sum;
}

glm::vec3 FarRadiance::even(const glm::vec3& light, const glm::vec3& view) const {
  const glm::vec3 turned(-1, -1, 1);
  return 0.5f * (at(light, view) + at(light * turned, view * turned));
}

EngineDirections fit_directions(const FarRadiance& cloth, float plane_weight, float ring_weight) {
  EngineDirections out;
  for (int p = 0; p < kPlanes; ++p) add_plane_lights(out.lights, 45.0f * static_cast<float>(p));
  const size_t in_planes = out.lights.size(), in_plane = in_planes / kPlanes;
  for (const float ring : kRingsAround)
    for (int a = 0; a < kAzimuthsAround; ++a)
      out.lights.push_back(direction(ring, (static_cast<float>(a) + 0.5f) * 360 / kAzimuthsAround));
  for (const float deg : kFitViews) {
    const float weight = deg > kSteepView ? kSteepWeight : 1.0f;
    const size_t first = out.pairs.size();
    for (size_t p = 0; p < kPlanes; ++p) {
      out.views.push_back(direction(deg, 45.0f * static_cast<float>(p)));
      const size_t view = out.views.size() - 1;
      const float plane = p % 2 == 0 ? plane_weight : kBetweenWeight;
      add_view(out, cloth, {view, deg, 0, 0, weight * plane, weight}, p * in_plane, (p + 1) * in_plane, false);
      add_view(out, cloth, {view, deg, 0, 0, weight * kAroundWeight, weight}, in_planes, out.lights.size(), true);
    }
    if (ring_weight > 0 && deg <= kSteepView)
      out.means.push_back({out.views.size() - 1, deg, first, out.pairs.size() - first, weight * ring_weight, 0});
  }
  return out;
}

EngineDirections plane_directions(const FarRadiance& cloth, bool warp) {
  EngineDirections out;
  add_plane_lights(out.lights, warp ? 90.0f : 0.0f);
  for (const float deg : kPlaneViews) {
    out.views.push_back(direction(deg, warp ? 90.0f : 0.0f));
    add_view(out, cloth, {out.views.size() - 1, deg}, 0, out.lights.size(), false);
  }
  return out;
}

EngineDirections grid_directions(const FarRadiance& cloth) {
  const std::array<glm::vec3, kResponseViews> w = response_views();
  const size_t rings = kResponseElevations, top = rings - 1;
  const auto fraction = [&w, top](size_t ring, size_t around) {
    const auto edge = [&](size_t k) {
      return k >= top ? 1.0f : 0.5f * (w[k * kViewAzimuths].z + w[(k + 1) * kViewAzimuths].z);
    };
    return (edge(ring) - (ring == 0 ? 0.0f : edge(ring - 1))) / static_cast<float>(around);
  };
  EngineDirections out;
  std::vector<float> parts;
  for (size_t k = kLowestNode; k < rings; ++k) {
    const size_t around = k == top ? 1 : kLightAzimuths;
    for (size_t a = 0; a < around; ++a) {
      out.lights.push_back(w[view_of_light(k * kLightAzimuths + a)]);
      parts.push_back(fraction(k, around));
    }
  }
  for (size_t k = rings; k-- > kLowestNode;) {
    const size_t around = k == top ? 1 : size_t{kViewAzimuths} / 2;
    for (size_t a = 0; a < around; ++a) {
      out.views.push_back(w[k * kViewAzimuths + a * (kViewAzimuths / around) % kViewAzimuths]);
      const glm::vec3 view = out.views.back();
      EngineView mean{out.views.size() - 1, std::acos(std::min(view.z, 1.0f)) / kRadians, out.pairs.size(),
                      parts.size()};
      for (size_t l = 0; l < parts.size(); ++l)
        out.pairs.push_back({mean.view, l, cloth.at(out.lights[l], view), parts[l]});
      out.means.push_back(mean);
    }
  }
  for (const EngineView& mean : out.means) normalise(out, mean);
  return out;
}

EngineDirections check_directions(const FarRadiance& cloth) {
  EngineDirections out;
  out.lights = {direction(kCheckLight, 270), direction(kCheckLight, 0)};
  for (const float deg : kCheckViews) {
    for (size_t a = 0; a < (deg == 0 ? 1 : 4); ++a) out.views.push_back(direction(deg, 90.0f * static_cast<float>(a)));
  }
  for (size_t l = 0; l < out.lights.size(); ++l)
    for (size_t v = 0; v < out.views.size(); ++v) out.pairs.push_back({v, l, cloth.at(out.lights[l], out.views[v]), 1});
  return out;
}

}  // namespace weftlight::light
