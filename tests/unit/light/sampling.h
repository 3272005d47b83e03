#pragma once
// Directions and quadratures for the tests of light.

#include <cmath>
#include <functional>
#include <random>

#include "light/formulas.h"

namespace weftlight::light {

inline glm::vec3 direction(float elevation_cosine, float azimuth) {
  const float s = std::sqrt(std::max(1 - elevation_cosine * elevation_cosine, 0.0f));
  return {s * std::cos(azimuth), s * std::sin(azimuth), elevation_cosine};
}

inline glm::vec3 at_degrees(float from_normal, float azimuth) {
  return direction(std::cos(from_normal * formulas::kPi / 180), azimuth * formulas::kPi / 180);
}

inline glm::vec3 random_upper(std::mt19937& rng) {
  std::uniform_real_distribution<float> u(0, 1);
  const float z = u(rng);
  return direction(z, u(rng) * 2 * formulas::kPi);
}

/// A random yarn, also with rotated lobes and without fuzz.
inline formulas::YarnLobes random_lobes(std::mt19937& rng) {
  std::uniform_real_distribution<float> u(0, 1);
  const auto colour = [&] { return glm::vec3(u(rng), u(rng), u(rng)); };
  formulas::YarnLobes y;
  const float a = 0.02f + 2 * u(rng) * u(rng), b = 0.02f + 2 * u(rng) * u(rng);
  y.slope_cov = {a * a, (1.8f * u(rng) - 0.9f) * a * b, b * b};
  y.f90 = u(rng);
  y.f0 = colour() * y.f90;
  const glm::vec3 body = colour();
  const float through = u(rng);
  y.body = body * (1 - through);
  y.through = body * through;
  y.fuzz_colour = colour();
  y.fuzz = u(rng) < 0.3f ? 0.0f : u(rng);
  y.fuzz_depth = 0.0025f + u(rng);
  y.fibre_layers = 1;
  return y;
}

/// Integral of f(wi) cos over the hemisphere by rings and turns of equal projected area.
inline glm::dvec3 furnace(const std::function<glm::vec3(glm::vec3)>& f, int rings, int turns) {
  glm::dvec3 sum(0);
  for (int i = 0; i < rings; ++i)
    for (int j = 0; j < turns; ++j) {
      const double u = (i + 0.5) / rings;  // squared: denser at grazing
      const double z = u * u;
      const glm::vec3 w = direction(static_cast<float>(z), static_cast<float>((j + 0.5) / turns * 2 * M_PI));
      sum += glm::dvec3(f(w)) * (z * 2 * u);
    }
  return sum * (2 * M_PI / (static_cast<double>(rings) * turns));
}

/// Albedo of single scattering of a lobe, red.
inline double scattered_once(const formulas::YarnLobes& y, const glm::vec3& wo) {
  const auto s = formulas::lobe_shared(y);
  const auto o = formulas::lobe_side(y, s, wo);
  const auto once = [&](glm::vec3 wi) {
    return formulas::lobe_specular(y, s, formulas::lobe_side(y, s, wi), o, wi, wo);
  };
  return furnace(once, 200, 200).x;
}

/// The same for a sharp lobe: the grid lies over facet slopes (reflected about wo) for the specular part, which is 0
/// elsewhere; `rest` is integrated by furnace().
inline glm::dvec3 slope_furnace(const formulas::YarnLobes& y, const glm::vec3& wo, int nodes = 160) {
  const formulas::LobeShared s = formulas::lobe_shared(y);
  const formulas::LobeSide o = formulas::lobe_side(y, s, wo);
  const float a = std::sqrt(s.cov.x), b = s.cov.y / a, c = std::sqrt(s.cov.z - b * b);  // Cholesky
  glm::dvec3 sum(0);
  // Uniform in the angles of both independent slopes, so that wide lobes are resolved where they reflect upwards.
  const double reach_a = std::atan(6.0 * static_cast<double>(a)), reach_c = std::atan(6.0 * static_cast<double>(c));
  for (int i = 0; i < nodes; ++i)
    for (int j = 0; j < nodes; ++j) {
      const double p = std::tan(reach_a * ((2 * i + 1.0) / nodes - 1)),
                   q = std::tan(reach_c * ((2 * j + 1.0) / nodes - 1));
      const double ds = (1 + p * p) * (1 + q * q) * 4 * reach_a * reach_c / (nodes * static_cast<double>(nodes));
      const float sx = static_cast<float>(p), sy = static_cast<float>(q) + b / a * sx;
      const float secant2 = 1 + sx * sx + sy * sy, faces = wo.z + wo.x * sx + wo.y * sy;
      if (faces <= 0) continue;
      const glm::vec3 wi = 2 * faces / secant2 * glm::vec3(sx, sy, 1) - wo;
      if (wi.z <= 0) continue;
      // dwi = 4 (wo.h) dh, dh = ds / secant^3: 4 faces ds / secant^4.
      const formulas::LobeSide side = formulas::lobe_side(y, s, wi);
      const glm::vec3 f = formulas::lobe_specular(y, s, side, o, wi, wo) * (1 - y.fuzz * (1 - side.clear * o.clear));
      sum += glm::dvec3(f) * (static_cast<double>(wi.z) * 4 * static_cast<double>(faces) /
                              (static_cast<double>(secant2) * static_cast<double>(secant2)) * ds);
    }
  const auto rest = [&](glm::vec3 wi) {
    const formulas::LobeSide i = formulas::lobe_side(y, s, wi);
    return formulas::lobe_reflect(y, s, i, o, wi, wo) -
           formulas::lobe_specular(y, s, i, o, wi, wo) * (1 - y.fuzz * (1 - i.clear * o.clear));
  };
  return sum + furnace(rest, 160, 24);
}

}  // namespace weftlight::light
