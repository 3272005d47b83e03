#pragma once
// Path tracing of the cloth: what a ray sees of the tubes, with the yarns' own lobes, true shadowing and masking,
// gaps, transmission through threads, and optional bounces. Cloth space, millimetres.
//
// Based on: Kajiya 1986 (rendering equation, estimated by following paths).

#include <array>
#include <functional>
#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "cloth/thread_texture.h"
#include "reference/interreflection.h"
#include "reference/sampling.h"
#include "reference/tubes.h"

namespace weftlight::reference {

using cloth::ThreadTexture;

/// Surroundings of a point of the cloth.
struct Surroundings {
  glm::vec3 light_towards{0, 0, 1};         // unit, cloth space
  float light_radius_rad = 0;               // half angle of its disc
  glm::vec3 light_irradiance{3.14159265f};  // at normal incidence
  /// Whether anything outside the cloth occludes the light in that direction. Empty: nothing does.
  std::function<bool(glm::vec3)> hidden;
  /// Radiance of the sky along a direction that leaves the cloth. Empty: black.
  std::function<glm::vec3(glm::vec3)> sky;
};

struct PathSample {
  glm::vec3 radiance{0};
  bool hit = false;  // false: the ray went through a gap
  // What was hit; of tubes alone.
  glm::vec3 direct{0};        // of the radiance, what lamp and sky send without another thread
  glm::vec3 normal{0, 0, 1};  // unit, of the thread with its fibres
  glm::vec3 albedo{0};        // colour of the fibres, linear
  System system = System::kWarp;
  int thread = 0;  // of the cloth's ends or picks
};

/// No single fibre is resolved.
inline constexpr float kCoarseSample_mm = 1e6f;

/// What the colour of a yarn stands for.
enum class Colours {
  kOfOneReflection,  // by the thread alone
  kOfTheCloth,       // by all threads together, as in the preview (interreflection.h); for traces with bounces
};

class ClothTracer {
 public:
  explicit ClothTracer(const TubeScene& tubes, Colours colours = Colours::kOfOneReflection);
  /// One sample of the radiance along a ray. `bounces`: indirect light between threads, 0 for none. sample_mm: its
  /// size on the cloth, which decides whether fibres are seen one by one (shaders/fibre_detail.glsl).
  PathSample trace(glm::vec3 origin, glm::vec3 direction, float t_min, const Surroundings& around,
                   RandomStream& sampler, int bounces, float sample_mm = kCoarseSample_mm) const;

 private:
  struct Point;
  Point point_of(const TubeHit& hit, glm::vec3 from, float sample_mm) const;
  glm::vec3 direct(const Point& point, const Surroundings& around, RandomStream& sampler) const;
  bool shadowed(const Point& point, glm::vec3 towards) const;
  static glm::vec3 reflected_from(const Point& point, glm::vec3 towards);
  HiddenParts hidden_parts() const;
  glm::vec3 alone(glm::vec3 position) const;

  const TubeScene& tubes_;
  std::array<std::vector<ThreadTexture>, 2> textures_;
  float ray_epsilon_mm_;  // offset of secondary rays
  std::optional<Interreflection> interreflection_;
};

}  // namespace weftlight::reference
