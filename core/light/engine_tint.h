#pragma once
// Base colour and reflectance of an engine's material that change with the view: cloth shows more of one system of
// threads at a slant along the other, and its highlight grows in another way than a lobe's. No engine knows that.

#include <array>
#include <cmath>
#include <glm/glm.hpp>
#include <span>

namespace weftlight::light {

/// Logarithms of the factors for a flat view along the weft (x) and along the warp (y).
struct ViewTint {
  glm::vec3 weft{0}, warp{0};            // of the base colour, by 1 - cosine
  glm::vec3 late_weft{0}, late_warp{0};  // and by its square, which comes in later
  glm::vec2 shine{0};                    // of the reflectance of the dielectric, along weft and warp, by the square
  /// Of the unit vector to the viewer: x^2 and y^2 over 1 + z, together 1 - z; both times 1 - z.
  static glm::vec4 slant(const glm::vec3& view) {
    const glm::vec2 flat = glm::vec2(view.x * view.x, view.y * view.y) / (1 + view.z);
    return {flat, flat * (1 - view.z)};
  }
  glm::vec3 base_at(const glm::vec3& view) const {
    const glm::vec4 s = slant(view);
    return glm::exp(weft * s.x + warp * s.y + late_weft * s.z + late_warp * s.w);
  }
  float shine_at(const glm::vec3& view) const {
    const glm::vec4 s = slant(view);
    return std::exp(shine.x * s.z + shine.y * s.w);
  }
};

/// The mean light of one view: what is wanted, what the material reflects, and what of that moves with each number of
/// its tint. By channel.
struct TintedMean {
  glm::vec3 weight{0};  // of the square of the difference
  glm::vec3 wanted{0}, whole{0}, body{0};
  std::array<glm::vec3, 4> body_by{};   // derivatives by the logarithms for slant(), with lights' where they count
  std::array<glm::vec3, 2> gloss_by{};  // and of the highlight
};

/// One step of least squares for the factors of the base colour and the tint. most_shine: largest logarithm.
void move_tint(glm::vec3& base, ViewTint& tint, float most_shine, std::span<const TintedMean> means);

}  // namespace weftlight::light
