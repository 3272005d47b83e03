// Any text as chart.csv: parsing never crashes, and a table of levels of detail chooses a method everywhere.

#include <cmath>
#include <cstdint>

#include "light/lod_table.h"
#include "require.h"

using weftlight::light::Expected, weftlight::light::LodPoint, weftlight::light::LodTable, weftlight::light::Plan,
    weftlight::light::expected, weftlight::light::expected_cost, weftlight::light::expected_error,
    weftlight::light::plan_of, weftlight::light::read_lod_table;

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  const LodTable lod_table = read_lod_table({reinterpret_cast<const char*>(data), size}).value_or(LodTable{});
  for (const LodPoint& point : lod_table) {
    for (const float yarns : {point.yarns_per_pixel, 0.0f, 1e-3f, 1.0f, 1e3f}) {
      require(!std::isnan(expected_error(lod_table, point.method, yarns, point.samples)),
              "an expected error is a number");
      require(!std::isnan(expected_cost(lod_table, point.method, yarns, point.samples)),
              "an expected cost is a number");
    }
  }
  const Plan plan = plan_of(lod_table, {0.05f});
  require(plan.methods[0] <= plan.methods[1] && plan.methods[1] <= plan.methods[2],
          "the thresholds between methods ascend");
  for (size_t k = 1; k < plan.lattices.size(); ++k)
    require(plan.lattices[k - 1] <= plan.lattices[k], "the thresholds between lattices ascend");
  for (const float yarns : {1e-3f, 0.1f, 1.0f, 1e3f}) {
    const Expected e = expected(lod_table, plan, yarns);
    require(!std::isnan(e.cost_ns) && !std::isnan(e.error), "expected cost and error are numbers");
  }
  return 0;
}
