#include "light/yarn_lobes.h"

#include <algorithm>
#include <cmath>

#include "draft/yarn_fields.h"

namespace weftlight::light {
namespace {

float unit(float v) { return v >= 0 ? std::min(v, 1.0f) : 0; }  // NaN: 0

glm::vec3 unit_colour(Linear c) { return {unit(c.r), unit(c.g), unit(c.b)}; }

}  // namespace

MirrorShares mirror_shares(const Lobes& any) {
  const Lobes lobes = clamped(any);
  const float root = (lobes.ior - 1) / (lobes.ior + 1), once = root * root;
  if (lobes.metallic) return {once, 1, 1, 0};
  const float pile = lobes.layers / (1 + (lobes.layers - 1) * once);
  return {pile * once, pile, lobes.inner, lobes.body};
}

interop::YarnData yarn_data(const Lobes& any) {
  const Lobes lobes = clamped(any);
  const Linear tint = linear_from_srgb(lobes.specular_tint);
  const MirrorShares shares = mirror_shares(lobes);
  interop::YarnData y{};
  y.along_width = lobes.along_width, y.across_width = lobes.across_width;
  y.specular = lobes.specular, y.reflectance = shares.clear, y.pile = shares.pile;
  y.body = shares.body, y.transmission = lobes.transmission;
  y.fuzz = lobes.fuzz, y.fuzz_width = lobes.fuzz_width, y.fuzz_depth = lobes.fuzz_width * lobes.fuzz_width;
  y.tint = {tint.r, tint.g, tint.b, shares.dyed};
  return y;
}

formulas::YarnLobes yarn_lobes(const Lobes& lobes, Linear thread_colour) {
  return formulas::yarn_of(yarn_data(lobes), unit_colour(thread_colour));
}

}  // namespace weftlight::light
