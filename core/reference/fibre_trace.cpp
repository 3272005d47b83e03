#include "reference/fibre_trace.h"

#include <algorithm>
#include <cmath>

#include "light/formulas.h"

namespace weftlight::reference {
namespace {

constexpr int kSureFibres = 6;      // met before roulette may end a path
constexpr float kFaint = 2e-3f;     // light from the lamp below this is looked for more rarely, at its full value
constexpr float kLongestExit = 12;  // radii, along a ray that hardly leaves the fibre
// Chosen with 64 samples of worsted, silk satin and linen damask: means within 1 % of those of 384 and more.
constexpr float kSpread64 = 0.3f;
constexpr int kWhollySpread = 12;  // fibres, after which the light is spread as far as it will be

/// A point on a fibre in its own frame: x along it, y towards the side that the light leaves to.
struct Meeting {
  const FibreHit& hit;
  glm::vec3 position;
  glm::vec3 y, z;
  glm::vec3 out;

  Meeting(const FibreHit& h, glm::vec3 direction) : hit(h) {
    const glm::vec3 towards = -direction;
    z = glm::cross(hit.axis, towards);
    const float length = glm::length(z);
    if (length < 1e-6f) {
      const glm::vec3 helper = std::abs(hit.axis.x) < 0.7f ? glm::vec3(1, 0, 0) : glm::vec3(0, 1, 0);
      z = glm::normalize(glm::cross(hit.axis, helper));
    } else {
      z /= length;
    }
    y = glm::cross(z, hit.axis);
    position = hit.centre + z * (hit.offset * hit.radius_mm);
    out = local(towards);
  }
  glm::vec3 local(glm::vec3 w) const { return {glm::dot(hit.axis, w), glm::dot(y, w), glm::dot(z, w)}; }
  glm::vec3 world(glm::vec3 l) const { return hit.axis * l.x + y * l.y + z * l.z; }

  /// Where a ray from the point leaves this fibre: it meets others only from there on.
  float exit(glm::vec3 direction) const {
    const glm::vec3 d = direction - hit.axis * glm::dot(hit.axis, direction);
    const glm::vec3 q = z * (hit.offset * hit.radius_mm);
    const float along = glm::dot(q, d), square = std::max(glm::dot(d, d), 1e-6f), r = hit.radius_mm;
    const float root = std::sqrt(std::max(along * along + square * (r * r - glm::dot(q, q)), 0.0f));
    return std::min((root - along) / square * 1.001f, kLongestExit * r);
  }
};

/// As it scatters light to further fibres: spread by this much along it.
formulas::FibreOptics spread(formulas::FibreOptics optics, float along) {
  constexpr float kAroundToAlong = 3;
  optics.along = std::min(std::hypot(optics.along, along), formulas::kMaxFibreWidth);
  optics.across = std::hypot(optics.across, kAroundToAlong * along);
  return optics;
}

float largest(glm::vec3 v) { return std::max({v.x, v.y, v.z}); }

/// Light from the lamp by way of one fibre of these optics.
glm::vec3 from_lamp(const FibreScene& fibres, const Meeting& at, const formulas::FibreOptics& optics,
                    const Surroundings& around, glm::vec3 weight, RandomStream& random) {
  const glm::vec3 towards = in_disc(around.light_towards, around.light_radius_rad, random);
  glm::vec3 light =
      formulas::fibre_scatter(optics, at.hit.offset, at.local(towards), at.out) * around.light_irradiance * weight;
  const float most = largest(light);
  if (!(most > 0)) return glm::vec3(0);
  if (most < kFaint) {
    const float chance = std::max(most / kFaint, 0.02f);
    if (random.next() >= chance) return glm::vec3(0);
    light /= chance;
  }
  if (fibres.occluded(at.position, towards, at.exit(towards))) return glm::vec3(0);
  if (around.hidden && around.hidden(towards)) return glm::vec3(0);
  return light;
}

}  // namespace

float lamp_spread(int samples) {
  return kSpread64 * std::pow(64.0f / static_cast<float>(std::max(samples, 1)), 1 / 6.0f);
}

bool FibreTracer::meet(glm::vec3 origin, glm::vec3 direction, float t_min, FibreHit& hit) const {
  if (!fibres_.intersect(origin, direction, t_min, hit)) return false;
  if (dyed_alike_) hit.optics.absorption = *dyed_alike_ * hit.depth;
  return true;
}

PathSample FibreTracer::trace(glm::vec3 origin, glm::vec3 direction, float t_min, const Surroundings& around,
                              RandomStream& random) const {
  PathSample traced;
  FibreHit hit;
  if (!meet(origin, direction, t_min, hit)) return traced;
  traced.hit = true;
  const bool lamp = largest(around.light_irradiance) > 0;
  glm::vec3 weight(1);
  for (int met = 0; met < kMaxFibres; ++met) {
    const Meeting at(hit, direction);
    if (lamp) {
      const float further = spread_ * static_cast<float>(std::min(met, kWhollySpread)) / kWhollySpread;
      traced.radiance += from_lamp(fibres_, at, spread(hit.optics, further), around, weight, random);
    }
    const float a = random.next(), b = random.next(), c = random.next();
    const glm::vec3 in = formulas::fibre_sample(hit.optics, hit.offset, at.out, {a, b, c, random.next()});
    const float density = in == glm::vec3(0) ? 0 : formulas::fibre_density(hit.optics, hit.offset, in, at.out);
    if (!(density > 1e-8f)) return traced;
    weight *= formulas::fibre_scatter(hit.optics, hit.offset, in, at.out) / density;
    if (met >= kSureFibres) {
      const float chance = std::min(largest(weight), 1.0f);
      if (!(random.next() < chance)) return traced;
      weight /= chance;
    }
    direction = glm::normalize(at.world(in));
    const glm::vec3 from = at.position;
    if (!meet(from, direction, at.exit(direction), hit)) {
      if (around.sky) traced.radiance += weight * around.sky(direction);
      return traced;
    }
  }
  return traced;
}

}  // namespace weftlight::reference
