// The families that analysis finds are those under which the table has its weaves.

#include <gtest/gtest.h>

#include <map>

#include "analysis/weave_family.h"
#include "draft/drawdown.h"
#include "weaves/table.h"

namespace weftlight::weaves {

using analysis::WeaveFamily, analysis::weave_family;

namespace {

std::string found(const char* id, const WeaveValues& values = {}) {
  const WeaveKind& kind = *find_weave(id);
  const WeaveValues whole = allowed_values(kind, complete_values(kind, values));
  const ClothSize size = whole_repeats(repeat_of(kind, whole), {96, 96});
  const WeaveFamily family = weave_family(draft::drawdown(new_draft(kind, whole, size).design.draft));
  return analysis::kWeaveFamilyNames[static_cast<size_t>(family)].id;
}

TEST(Family, WeavesOfTheTableAreKnown) {
  const std::map<std::string, std::vector<const char*>> families{
      {"plain", {"plain", "log_cabin"}},
      {"basket", {"basket"}},
      {"twill",
       {"straight", "twill", "broken_twill", "point_twill", "herringbone", "advancing_twill", "undulating_twill",
        "network", "houndstooth", "glen_check", "sett", "corkscrew"}},
      {"satin", {"satin"}},
      {"block", {"damask"}},
      {"lace", {"huck", "bronson", "bronson_lace", "canvas", "ms_and_os", "swivel"}},
      {"pattern", {"overshot", "summer_winter", "clipped_spots", "beiderwand", "taquete"}},
      {"double", {"double", "double_blocks", "stitched", "deflected"}},
      {"cells", {"waffle", "honeycomb"}},
      {"parallel", {"echo", "jin", "shadow"}},
  };
  for (const auto& [family, weaves] : families)
    for (const char* weave : weaves) EXPECT_EQ(found(weave), family) << weave;
}

}  // namespace
}  // namespace weftlight::weaves
