// There is no Cairo (WEFTLIGHT_CAIRO is off): the chart's table is written, and its figures are not.

#include "chart/plot.h"

#include "base/text.h"

namespace weftlight::chart::plot {

base::Result<void> write_figure(const Figure& /*figure*/, const std::string& base) {
  return base::failure(base::ErrorKind::kOutput, base::tr("this build cannot write .svg or .pdf; write a .png"),
                       base + ".svg");
}

void fit_log(PlotAxis& /*axis*/, const std::vector<double>& /*values*/) {}

}  // namespace weftlight::chart::plot
