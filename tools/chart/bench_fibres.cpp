// Measurements against traced fibres (fibre_rows.h).

#include <algorithm>

#include "chart/bench.h"
#include "chart/flip.h"

namespace weftlight::chart {

using design::method_name;
using reference::FibreOptions, reference::FibreScene, reference::trace_flat;

namespace {

/// The part of the cloth that a patch shows.
FibreOptions fibres_of(glm::vec2 corner, const PixelSteps& steps, int pixels) {
  FibreOptions options;
  options.low_mm = options.high_mm = corner;
  const auto side = static_cast<float>(pixels);
  for (const glm::vec2 at : {side * steps.x, side * steps.y, side * (steps.x + steps.y)}) {
    options.low_mm = glm::min(options.low_mm, corner + at);
    options.high_mm = glm::max(options.high_mm, corner + at);
  }
  return options;
}

}  // namespace

base::Result<std::vector<FibreRow>> ChartBench::against_fibres(size_t scene, int view_deg, double yarns_per_pixel) {
  const base::Result<Loaded*> shown = show(scene);
  if (!shown) return failed(shown);
  const base::Result<const TubeScene*> tubes_traced = tubes(**shown);
  if (!tubes_traced) return failed(tubes_traced);
  ChartRow cell;
  cell.scene = kChartScenes[scene].name, cell.view_deg = view_deg, cell.yarns_per_pixel = yarns_per_pixel;
  const PixelSteps pixel = pixel_of(cell);
  const int size = std::min(patch_pixels(yarns_per_pixel, effort_), effort_.fibre_pixels);
  const auto fibres = FibreScene::build((*shown)->cloth, fibres_of(chart_corner(), pixel, size));
  if (!fibres) return failed(fibres);
  Truth of_fibres, of_tubes;
  for (const uint64_t seed : {1u, 2u}) {
    const reference::FlatPicture picture = traced_patch(view_deg, pixel, size, seed);
    (seed == 1 ? of_fibres.half : of_fibres.other_half) = colours(trace_flat(**fibres, picture, {}));
    (seed == 1 ? of_tubes.half : of_tubes.other_half) = colours(trace_flat(**tubes_traced, picture, {}));
  }
  const Pixels mean = mean_of(of_fibres);
  std::vector<FibreRow> rows;
  const auto add = [&](const std::string& name, int samples, const Pixels& drawn) {
    rows.push_back({cell.scene, view_deg, yarns_per_pixel, name, samples,
                    relative_rmse(drawn, of_fibres.half, of_fibres.other_half),
                    relative_rmse(drawn, of_tubes.half, of_tubes.other_half), flip_error(drawn, mean, size, size),
                    mean_ratio(drawn, mean)});
  };
  add("tubes", 0, mean_of(of_tubes));
  rows.back().tube_error = 0;
  for (const NearMethod& near : near_methods())
    add(std::string(method_name(near.method)), near.samples,
        draw(near.method, view_deg, chart_corner(), pixel, size, size, near.samples));
  return rows;
}

}  // namespace weftlight::chart
