#include "draft/yarn.h"

#include <algorithm>
#include <cmath>

namespace weftlight::draft {
namespace {

void bound(float& value, float low, float high, float fallback) {
  value = std::isnan(value) ? fallback : std::clamp(value, low, high);
}

void bound_unit(Rgb& c) {
  bound(c.r, 0, 1, 1);
  bound(c.g, 0, 1, 1);
  bound(c.b, 0, 1, 1);
}

void bound(Lobes& lobes) {
  const Lobes usual;
  bound(lobes.specular, 0, 1, usual.specular);
  bound_unit(lobes.specular_tint);
  bound(lobes.ior, 1, 3, usual.ior);
  bound(lobes.along_width, 0, 4, usual.along_width);
  bound(lobes.across_width, 0, 4, usual.across_width);
  bound(lobes.body, 0, 1, usual.body);
  bound(lobes.fuzz, 0, 1, usual.fuzz);
  bound(lobes.fuzz_width, 0.05f, 1, usual.fuzz_width);
  bound(lobes.transmission, 0, 1, usual.transmission);
}

}  // namespace

Yarn clamped(Yarn yarn) {
  const Yarn usual;
  bound(yarn.diameter_mm, 0, 50, usual.diameter_mm);
  bound(yarn.turns_per_m, 0, 5000, usual.turns_per_m);
  yarn.plies = std::clamp(yarn.plies, 1, 8);
  bound(yarn.fibre_um, 1, 2000, usual.fibre_um);
  bound(yarn.groove_depth, 0, 1, usual.groove_depth);
  bound(yarn.hairiness, 0, 1, usual.hairiness);
  bound(yarn.flattening, 0.3f, 1, usual.flattening);
  bound(yarn.lobes);
  return yarn;
}

}  // namespace weftlight::draft
