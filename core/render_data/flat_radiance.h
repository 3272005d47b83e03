#pragma once
// What a flat cloth sends back, from afar, under one directional light and nothing else: on the CPU by method `cloth`,
// or ray traced as threads or as fibres.

#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "cloth/cloth.h"

namespace weftlight::render_data {

using cloth::Cloth;

/// Angles from the normal, in the plane of incidence that holds the warp (or the weft), positive towards growing picks
/// (ends). Lights beyond 90 shine from behind.
struct FlatDirections {
  bool warp = true;
  double view_deg = 0, light_deg = 0;
};
/// The unit vector in cloth space: x along the weft, y along the warp, z out of the face.
glm::vec3 unit_direction(bool warp, double degrees);

/// Radiance for unit irradiance at normal incidence, linear RGB, one for each of `directions`. A white Lambertian
/// surface has cos(light) / pi. Takes about a tenth of a second.
std::vector<glm::vec3> evaluated_radiance(const Cloth& cloth, std::span<const FlatDirections> directions);

/// How threads are traced. bounces: of light from thread to thread; with 0, one reflection stands for all of them.
struct FlatTrace {
  int spp = 16, bounces = 0;
};

/// The same ray traced through the threads as tubes, `spp` rays in each of 1,024 samples of the period. An error if it
/// has too many crossings; of kCancelled if it was stopped.
base::Result<std::vector<glm::vec3>> traced_radiance(const Cloth& cloth, std::span<const FlatDirections> directions,
                                                     FlatTrace trace, const base::TaskProgress& progress = {});

/// The same of its fibres, over whole periods of at least 2 mm, or 2 mm of longer ones. An error if they need too much
/// memory; of kCancelled if it was stopped.
base::Result<std::vector<glm::vec3>> fibre_radiance(const Cloth& cloth, std::span<const FlatDirections> directions,
                                                    int spp, const base::TaskProgress& progress = {});

}  // namespace weftlight::render_data
