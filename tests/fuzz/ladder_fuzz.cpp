// Any text as chart.csv: reading never crashes, and a ladder that is read chooses a rung everywhere.

#include <cmath>
#include <cstdint>

#include "light/ladder.h"
#include "require.h"

using namespace weftlight::light;

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  std::string problem;
  const Ladder ladder = read_ladder({reinterpret_cast<const char*>(data), size}, problem);
  require(problem.empty() || ladder.empty(), "a ladder with a problem is empty");
  for (const LadderPoint& point : ladder) {
    for (const float yarns : {point.yarns_per_pixel, 0.0f, 1e-3f, 1.0f, 1e3f}) {
      require(!std::isnan(expected_error(ladder, point.method, yarns, point.samples)), "an expected error is a number");
      require(!std::isnan(expected_cost(ladder, point.method, yarns, point.samples)), "an expected cost is a number");
    }
  }
  const Plan plan = plan_of(ladder, {0.05f});
  require(plan.rungs[0] <= plan.rungs[1] && plan.rungs[1] <= plan.rungs[2], "the edges between rungs rise");
  for (size_t k = 1; k < plan.lattices.size(); ++k)
    require(plan.lattices[k - 1] <= plan.lattices[k], "the edges between lattices rise");
  for (const float yarns : {1e-3f, 0.1f, 1.0f, 1e3f}) {
    const Expected e = expected(ladder, plan, yarns);
    require(!std::isnan(e.cost_ns) && !std::isnan(e.error), "what is expected is a number");
  }
  return 0;
}
