#include "chart/drapes.h"

#include <sstream>

namespace weftlight::chart {

using design::method_name;

std::vector<DrapeRow> drape_cells(const std::vector<Method>& methods, const ChartEffort& effort) {
  std::vector<DrapeRow> cells;
  for (const char* scene : kDrapedScenes) {
    for (const ChartLight light : kDrapeLights) {
      for (size_t f = kDrapeFootprints.size() - effort.drape_footprints; f < kDrapeFootprints.size(); ++f) {
        for (const Method method : methods) {
          DrapeRow cell;
          cell.scene = scene, cell.light = light, cell.yarns_per_pixel = kDrapeFootprints[f], cell.method = method;
          cells.push_back(cell);
        }
      }
    }
  }
  return cells;
}

std::string drapes_csv(const std::vector<DrapeRow>& rows) {
  std::ostringstream out;
  out << "mesh,scene,light,yarns_per_pixel,method,ns_per_pixel,rel_rmse_model,flip,energy_ratio,rel_rmse_noise\n";
  for (const DrapeRow& r : rows) {
    out << kChartDrape << ',' << r.scene << ',' << light_name(r.light) << ',' << r.yarns_per_pixel << ','
        << method_name(r.method) << ',' << r.ns_per_pixel << ',' << r.model_error << ',' << r.flip << ','
        << r.energy_ratio << ',' << r.truth_noise << '\n';
  }
  return out.str();
}

Scene drape_scene(ChartLight light) {
  constexpr float kBehindAzimuth = 165, kBehindElevation = 25;  // degrees; the eye is at 25
  Scene scene;
  scene.mesh = kChartDrape;
  scene.view_elevation = 8;
  if (light != ChartLight::kSky) scene.sky_strength = 0;
  if (light == ChartLight::kSky) scene.light_strength = 0;
  if (light == ChartLight::kBehind) scene.light_azimuth = kBehindAzimuth, scene.light_elevation = kBehindElevation;
  return scene;
}

}  // namespace weftlight::chart
