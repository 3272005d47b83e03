#include "views/common/yarn_strip.h"

#include <algorithm>
#include <cmath>

#include "cloth/thread_texture.h"
#include "light/yarn_lobes.h"

namespace weftlight::views {

namespace thread_formulas = cloth::thread_formulas;

using cloth::Texel, cloth::ThreadBody, cloth::ThreadTexture, cloth::linear_from_srgb, cloth::srgb_from_linear,
    cloth::texture_at, cloth::thread_texture;
using draft::System;
using light::yarn_lobes;

namespace {

constexpr float kPi = 3.14159265f;
constexpr float kFill = 0.84f;        // thread diameter, as a fraction of the strip's height
constexpr float kKey = 2.6f;          // irradiance at normal incidence; white paper then has radiance 0.83
constexpr float kSky = 0.28f;         // radiance of the uniform environment
constexpr float kLightAbove = 0.55f;  // y of the light direction, relative to its z

/// A round thread along x, seen from +z; lengths in radii, y up.
struct Thread {
  ThreadTexture texture;
  formulas::YarnLobes lobes;
  formulas::LobeShared shared;
  glm::vec3 colour;  // linear
  glm::vec3 light;
  float length;  // radii
  float pixel;   // radii
};

Thread thread_of(const Yarn& yarn, Rgb colour, float light_deg, int width, int height) {
  Thread t;
  const float radius_mm = 0.5f * std::max(yarn.diameter_mm, 0.01f);
  t.pixel = 2.0f / (kFill * static_cast<float>(height));
  t.length = t.pixel * static_cast<float>(width);
  ThreadBody body;
  body.width_mm = body.height_mm = 2 * radius_mm;
  body.colour = linear_from_srgb(colour);
  t.texture = thread_texture(yarn, body, System::kWeft, 0, t.length * radius_mm);
  t.colour = {body.colour.r, body.colour.g, body.colour.b};
  t.lobes = yarn_lobes(yarn.lobes, body.colour);
  t.shared = formulas::lobe_shared(t.lobes);
  const float a = light_deg * kPi / 180;
  t.light = glm::normalize(glm::vec3(std::sin(a), kLightAbove * std::cos(a), std::cos(a)));
  return t;
}

/// Texture look-up as in the ray tracer (core/reference/trace.cpp), filtered over the pixel's footprint.
Texel texel_at(const Thread& t, float x, glm::vec3 normal) {
  const ThreadTexture& texture = t.texture;
  const float turn = 0.25f - std::atan2(normal.z, normal.y) / (2 * kPi), u = x / t.length;
  const float down = texture.fibres * t.pixel / (2 * kPi * std::max(normal.z, 0.05f));
  const float along = static_cast<float>(std::abs(texture.advance)) * t.pixel / t.length;
  return texture_at(texture, thread_formulas::texture_point(texture, u, turn, std::hypot(down, along), 1));
}

glm::vec3 radiance(const Thread& t, float x, float y) {
  const glm::vec3 eye(0, 0, 1), axis(1, 0, 0), across(0, 1, 0);
  glm::vec3 normal(0, y, std::sqrt(std::max(1 - y * y, 1e-4f)));
  const Texel texel = texel_at(t, x, normal);
  const glm::vec3 around = glm::normalize(across - normal * normal.y + axis * 1e-6f);
  if (t.texture.plies > 1) {
    // Slope of the furrows, as in the ray tracer.
    const float slant = 4 * t.texture.ply_relief_mm / t.texture.radius_mm * texel.ply;
    normal = glm::normalize(normal + around * (slant * static_cast<float>(t.texture.plies) / (2 * kPi)) +
                            axis * (slant * static_cast<float>(t.texture.ply_advance) / t.length));
    normal.z = std::max(normal.z, 0.02f);
  }
  const formulas::LobeFrame frame = formulas::lobe_frame(glm::normalize(normal), axis + around * t.texture.fibre_tan);
  const glm::vec3 wi = formulas::lobe_local(frame, t.light), wo = formulas::lobe_local(frame, eye);
  const formulas::LobeSide out = formulas::lobe_side(t.lobes, t.shared, wo);
  const formulas::LobeSide in = formulas::lobe_side(t.lobes, t.shared, {wi.x, wi.y, std::abs(wi.z)});
  const glm::vec3 f = wi.z > 0 ? formulas::lobe_reflect(t.lobes, t.shared, in, out, wi, wo)
                               : formulas::lobe_transmit(t.lobes, t.shared, in, out);
  const glm::vec3 lit = f * (kKey * std::abs(wi.z)) + formulas::lobe_albedo(t.lobes, t.shared, out) * kSky;
  return lit * thread_formulas::fibre_tint(texel, t.colour) * texel.groove;
}

ImU32 encoded(glm::vec3 radiance, float alpha) {
  const glm::vec3 mapped = formulas::tone_map(radiance);
  return to_u32(srgb_from_linear({mapped.r, mapped.g, mapped.b}), alpha);
}

}  // namespace

std::vector<ImU32> yarn_strip(const Yarn& yarn, Rgb colour, float light_deg, int width, int height) {
  const Thread t = thread_of(yarn, colour, light_deg, width, height);
  std::vector<ImU32> pixels;
  pixels.reserve(static_cast<size_t>(width) * static_cast<size_t>(height));
  for (int row = 0; row < height; ++row) {
    const float y = (0.5f * static_cast<float>(height) - static_cast<float>(row) - 0.5f) * t.pixel;
    const float alpha = std::clamp((1 - std::abs(y)) / t.pixel + 0.5f, 0.0f, 1.0f);
    for (int column = 0; column < width; ++column) {
      const float x = (static_cast<float>(column) + 0.5f) * t.pixel;
      pixels.push_back(alpha > 0 ? encoded(radiance(t, x, std::clamp(y, -0.999f, 0.999f)), alpha) : 0);
    }
  }
  return pixels;
}

ImTextureID YarnStrip::of(const Yarn& yarn, Rgb colour, float light_deg, int width, int height) {
  Key key{yarn, colour, light_deg, width, height};
  if (texture_.empty() || !(key == key_)) {
    texture_.set(width, height, yarn_strip(yarn, colour, light_deg, width, height));
    key_ = std::move(key);
  }
  return texture_.id();
}

}  // namespace weftlight::views
