#include "chart/fibre_rows.h"

#include <sstream>

#include "light/formulas.h"

namespace weftlight::chart {

std::vector<NearMethod> near_methods() {
  return {{Method::kYarn, formulas::kMaxYarnSamples},
          {Method::kYarn, 5},
          {Method::kAuto, 0},
          {Method::kRepeat, 1},
          {Method::kCell, 1},
          {Method::kFlat, 1}};
}

std::string fibres_csv(const std::vector<FibreRow>& rows) {
  std::ostringstream out;
  out << "scene,view_deg,yarns_per_pixel,method,samples,rel_rmse_fibres,rel_rmse_tubes,flip_fibres,energy_ratio\n";
  for (const FibreRow& r : rows)
    out << r.scene << ',' << r.view_deg << ',' << r.yarns_per_pixel << ',' << r.method << ',' << r.samples << ','
        << r.fibre_error << ',' << r.tube_error << ',' << r.fibre_flip << ',' << r.energy_ratio << '\n';
  return out.str();
}

}  // namespace weftlight::chart
