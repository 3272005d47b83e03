#include "reference/trace.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "light/formulas.h"
#include "light/yarn_lobes.h"

namespace weftlight::reference {

namespace thread_formulas = cloth::thread_formulas;

using cloth::Cloth, cloth::FibreDetail, cloth::Linear, cloth::Texel, cloth::ThreadBody, cloth::fibre_detail,
    cloth::texture_at, cloth::thread_textures;
using design::Yarn;
using draft::System;
using light::yarn_lobes;

namespace {

/// What the maps hold of a thread's surface, bundles and the relief of plies, resolved by each ray; no single fibre.
FibreDetail detail_of_maps(const cloth::ThreadTexture& texture, float fraction, float turn) {
  FibreDetail detail{};
  detail.texel = texture_at(texture, thread_formulas::texture_point(texture, fraction, turn, 0, 1));
  detail.fibre_tan = texture.fibre_tan;
  return detail;
}

constexpr float kPi = std::numbers::pi_v<float>;
constexpr int kHiddenRays = 20'000;  // the hidden parts are then within half a percent

}  // namespace

/// A point on a thread, ready for shading.
struct ClothTracer::Point {
  glm::vec3 position, smooth;  // smooth: normal of the section, towards the viewer
  formulas::LobeFrame frame;
  formulas::YarnLobes lobes;
  formulas::LobeShared shared;
  formulas::LobeSide out;
  glm::vec3 local_out{0};
  float groove = 1;
  glm::vec3 colour{0};  // of the fibres
  thread_formulas::SurfaceFrame surface;
  const ThreadTexture* texture = nullptr;
  FibreDetail detail;
  float length_mm = 1;
  /// Light from a direction that the next ply of the thread leaves.
  float among_plies(glm::vec3 towards) const {
    return thread_formulas::ply_light(surface, *texture, detail, length_mm, towards);
  }
  System system = System::kWarp;
  int thread = 0;
};

ClothTracer::ClothTracer(const TubeScene& tubes, Colours colours)
    : tubes_(tubes), textures_(thread_textures(tubes.cloth())) {
  ray_epsilon_mm_ = 2e-4f * std::max(tubes.z_max() - tubes.z_min(), 1e-4f);
  if (colours == Colours::kOfTheCloth) interreflection_.emplace(tubes.cloth(), hidden_parts());
}

/// Seen from straight above, where a preview and a photograph show most of a cloth.
HiddenParts ClothTracer::hidden_parts() const {
  const Cloth& cloth = tubes_.cloth();
  RandomStream random(1);
  std::array<double, 2> hidden{}, reflectance{}, seen{};
  for (int i = 0; i < kHiddenRays; ++i) {
    const float x = cloth.width_mm * random.next(), y = cloth.depth_mm * random.next();
    TubeHit hit;
    const glm::vec3 down(0, 0, -1);
    if (!tubes_.intersect({x, y, tubes_.z_max() + 1}, down, 0, hit)) continue;
    const Point p = point_of(hit, -down, kCoarseSample_mm);
    const size_t s = hit.system == System::kWarp ? 0 : 1;
    seen[s] += 1;
    reflectance[s] += static_cast<double>(light::channel_mean(
        reflectance_of(cloth, (s == 0 ? cloth.ends : cloth.picks)[static_cast<size_t>(hit.thread)])));
    const glm::vec3 towards = cosine_direction(p.frame.n, random);
    if (glm::dot(towards, p.smooth) <= 0 || !tubes_.occluded(p.position + p.smooth * ray_epsilon_mm_, towards, 0))
      continue;
    hidden[s] += static_cast<double>(light::channel_mean(reflected_from(p, towards)));
  }
  HiddenParts out{};
  for (size_t s = 0; s < 2; ++s) {
    if (reflectance[s] > 0) out[s] = static_cast<float>(hidden[s] / (seen[0] + seen[1]) / (reflectance[s] / seen[s]));
  }
  return out;
}

glm::vec3 ClothTracer::alone(glm::vec3 position) const {
  return interreflection_ ? interreflection_->alone(glm::vec2(position)) : glm::vec3(1);
}

ClothTracer::Point ClothTracer::point_of(const TubeHit& hit, glm::vec3 from, float sample_mm) const {
  const Cloth& cloth = tubes_.cloth();
  const bool warp = hit.system == System::kWarp;
  const size_t index = static_cast<size_t>(hit.thread);
  const ThreadBody& body = (warp ? cloth.ends : cloth.picks)[index];
  const ThreadTexture& texture = textures_[warp ? 0 : 1][index];
  const float length = warp ? cloth.depth_mm : cloth.width_mm;

  // Texture turns count from the top of the section towards +across (core/cloth/surface_sampler.cpp).
  const float turn = 0.25f - hit.around_rad / (2 * kPi), periods = hit.along_mm / length;
  const float fraction = periods - std::floor(periods);
  const FibreDetail detail =
      sample_mm < kCoarseSample_mm
          ? fibre_detail(texture, fraction, turn,
                         thread_formulas::sample_size(texture, sample_mm, hit.normal.z, length), length)
          : detail_of_maps(texture, fraction, turn);
  const Texel& texel = detail.texel;

  Point p;
  p.position = hit.position;
  p.system = hit.system;
  p.thread = hit.thread;
  p.groove = texel.groove;
  const glm::vec3 across = warp ? glm::vec3(1, 0, 0) : glm::vec3(0, 1, 0);
  const glm::vec3 around = glm::normalize(across - hit.normal * glm::dot(across, hit.normal) + hit.axis * 1e-6f);
  p.smooth = glm::dot(hit.normal, from) >= 0 ? hit.normal : -hit.normal;
  const Yarn& yarn = cloth.yarns[static_cast<size_t>(body.yarn)];
  const Linear& dye = colour_along(cloth, hit.system, hit.thread, hit.along_mm);
  const glm::vec3 colour = thread_formulas::fibre_colour(texel, {dye.r, dye.g, dye.b});
  p.colour = colour;
  p.lobes = yarn_lobes(yarn.lobes, {colour.r, colour.g, colour.b});
  const float relief = thread_formulas::fibre_relief(p.lobes.slope_cov.z, formulas::nap_of(p.lobes.fuzz));
  const glm::vec3 normal =
      thread_formulas::detail_normal({p.smooth, hit.axis, around}, texture, detail, relief, length, from);
  p.groove *= thread_formulas::detail_gain(texture, detail, relief);
  p.surface = {p.smooth, hit.axis, around};
  p.texture = &texture, p.detail = detail, p.length_mm = length;
  p.frame = formulas::lobe_frame(normal, hit.axis + around * detail.fibre_tan);
  p.lobes = formulas::detail_lobes(p.lobes, detail.resolved, relief);
  p.shared = formulas::lobe_shared(p.lobes);
  p.local_out = formulas::lobe_local(p.frame, from);
  p.out = formulas::lobe_side(p.lobes, p.shared, p.local_out);
  return p;
}

/// Light from behind first passes through the thread itself; every other thread occludes it.
bool ClothTracer::shadowed(const Point& p, glm::vec3 towards) const {
  const bool front = glm::dot(p.smooth, towards) > 0;
  const glm::vec3 from = p.position + p.smooth * (front ? ray_epsilon_mm_ : -ray_epsilon_mm_);
  if (front) return tubes_.occluded(from, towards, 0);
  TubeHit exit;
  float start = 0;
  for (int crossings = 0; crossings < 4 && tubes_.intersect(from, towards, start, exit); ++crossings) {
    if (exit.system != p.system || exit.thread != p.thread) return true;
    start = exit.t + ray_epsilon_mm_;
  }
  return false;
}

glm::vec3 ClothTracer::direct(const Point& p, const Surroundings& around, RandomStream& sampler) const {
  const glm::vec3 towards = in_disc(around.light_towards, around.light_radius_rad, sampler);
  const glm::vec3 local = formulas::lobe_local(p.frame, towards);
  glm::vec3 f;
  if (local.z > 0) {
    f = formulas::lobe_reflect(p.lobes, p.shared, formulas::lobe_side(p.lobes, p.shared, local), p.out, local,
                               p.local_out);
  } else {
    const glm::vec3 mirrored(local.x, local.y, -local.z);
    f = formulas::lobe_transmit(p.lobes, p.shared, formulas::lobe_side(p.lobes, p.shared, mirrored), p.out);
  }
  if (f.x + f.y + f.z <= 0) return glm::vec3(0);
  if (shadowed(p, towards) || (around.hidden && around.hidden(towards))) return glm::vec3(0);
  return f * around.light_irradiance * (std::abs(local.z) * p.groove * p.among_plies(towards));
}

/// Light from a direction drawn by cosine over that density: f cos / pdf = pi f.
glm::vec3 ClothTracer::reflected_from(const Point& p, glm::vec3 towards) {
  const glm::vec3 local = formulas::lobe_local(p.frame, towards);
  return formulas::lobe_reflect(p.lobes, p.shared, formulas::lobe_side(p.lobes, p.shared, local), p.out, local,
                                p.local_out) *
         (kPi * p.groove);
}

PathSample ClothTracer::trace(glm::vec3 origin, glm::vec3 direction, float t_min, const Surroundings& around,
                              RandomStream& sampler, int bounces, float sample_mm) const {
  PathSample traced;
  TubeHit hit;
  if (!tubes_.intersect(origin, direction, t_min, hit)) return traced;
  traced.hit = true;
  glm::vec3 weight(1);
  for (int depth = 0;; ++depth) {
    const Point p = point_of(hit, -direction, depth == 0 ? sample_mm : kCoarseSample_mm);
    weight *= alone(p.position);
    const glm::vec3 lit = weight * direct(p, around, sampler);
    traced.radiance += lit;
    if (depth == 0) {
      traced.direct = lit;
      traced.normal = p.frame.n, traced.albedo = p.colour;
      traced.system = p.system, traced.thread = p.thread;
    }
    if (depth == bounces && !around.sky) return traced;
    direction = cosine_direction(p.frame.n, sampler);
    if (glm::dot(direction, p.smooth) <= 0) return traced;
    weight *= reflected_from(p, direction);
    const glm::vec3 from = p.position + p.smooth * ray_epsilon_mm_;
    if (!tubes_.intersect(from, direction, 0, hit)) {
      if (!around.sky) return traced;
      const glm::vec3 from_sky = weight * around.sky(direction) * p.among_plies(direction);
      traced.radiance += from_sky;
      if (depth == 0) traced.direct += from_sky;
      return traced;
    }
    if (depth == bounces) return traced;
  }
}

}  // namespace weftlight::reference
