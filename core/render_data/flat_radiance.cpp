#include "render_data/flat_radiance.h"

#include <cmath>
#include <numbers>

#include "base/text.h"
#include "reference/picture.h"
#include "render_data/far_field.h"

namespace weftlight::render_data {

using base::ErrorKind, base::Result, base::TaskProgress, base::failed, base::failure, base::tr;
using reference::Colours, reference::FibreOptions, reference::FibreScene, reference::FlatPicture, reference::TubeScene,
    reference::trace_flat;

namespace {

constexpr int kTracedPixels = 32;    // along each side of what is traced
constexpr float kFibrePatch_mm = 2;  // least size of the fibres' patch, so that no single fibre stands for all

/// The mean of a patch of this size, for each pair of directions.
template <typename Threads>
Result<std::vector<glm::vec3>> traced(const Threads& threads, glm::vec2 size_mm,
                                      std::span<const FlatDirections> directions, FlatTrace trace,
                                      const TaskProgress& progress) {
  std::vector<glm::vec3> out;
  FlatPicture picture;
  picture.width = picture.height = kTracedPixels;
  picture.spp = trace.spp, picture.bounces = trace.bounces;
  if (trace.bounces > 0) picture.colours = Colours::kOfTheCloth;
  picture.step_x_mm = {size_mm.x / kTracedPixels, 0}, picture.step_y_mm = {0, size_mm.y / kTracedPixels};
  picture.around.light_irradiance = glm::vec3(1);
  for (const FlatDirections& d : directions) {
    if (progress.stopped()) return failure(ErrorKind::kCancelled, tr("stopped"));
    picture.view = unit_direction(d.warp, d.view_deg);
    picture.around.light_towards = unit_direction(d.warp, d.light_deg);
    glm::vec3 sum(0);
    for (const glm::vec4& p : trace_flat(threads, picture, {}).pixels) sum += glm::vec3(p);
    out.push_back(sum / static_cast<float>(kTracedPixels * kTracedPixels));
    progress.report(static_cast<float>(out.size()) / static_cast<float>(directions.size()));
  }
  return out;
}

}  // namespace

glm::vec3 unit_direction(bool warp, double degrees) {
  const double a = degrees * std::numbers::pi / 180;
  const float side = static_cast<float>(std::sin(a)), up = static_cast<float>(std::cos(a));
  return warp ? glm::vec3(0, side, up) : glm::vec3(side, 0, up);
}

std::vector<glm::vec3> evaluated_radiance(const Cloth& cloth, std::span<const FlatDirections> directions) {
  const FarField far = far_field(cloth);
  std::vector<glm::vec3> out;
  for (const FlatDirections& d : directions)
    out.push_back(far_field_radiance(far, unit_direction(d.warp, d.light_deg), unit_direction(d.warp, d.view_deg)));
  return out;
}

Result<std::vector<glm::vec3>> traced_radiance(const Cloth& cloth, std::span<const FlatDirections> directions,
                                               FlatTrace trace, const TaskProgress& progress) {
  const auto tubes = TubeScene::build(cloth, {});
  if (!tubes) return failed(tubes);
  return traced(**tubes, {cloth.width_mm, cloth.depth_mm}, directions, trace, progress);
}

Result<std::vector<glm::vec3>> fibre_radiance(const Cloth& cloth, std::span<const FlatDirections> directions, int spp,
                                              const TaskProgress& progress) {
  const auto whole = [](float period) {
    return period < kFibrePatch_mm ? period * std::ceil(kFibrePatch_mm / period) : kFibrePatch_mm;
  };
  FibreOptions options;
  options.high_mm = {whole(cloth.width_mm), whole(cloth.depth_mm)};
  const auto fibres = FibreScene::build(cloth, options);
  if (!fibres) return failed(fibres);
  return traced(**fibres, options.high_mm, directions, {spp, 0}, progress);
}

}  // namespace weftlight::render_data
