// Plain weave and what is nearest to it.

#include "base/mark.h"
#include "weaves/kinds.h"
#include "weaves/makers.h"
#include "weaves/parameters.h"

namespace weftlight::weaves {

using base::mark;

using Values = const WeaveValues&;

std::vector<WeaveKind> simple_kinds() {
  const char* family = mark("Simple");
  return {
      {"plain",
       mark("Plain"),
       family,
       mark("Each thread goes over one and under one. The firmest weave: the ground of most cloths, from gauze to "
            "canvas."),
       {},
       [](Values, ClothSize size) {
         return GeneratedWeave{plain(size), {}};
       }},
      {"straight",
       mark("Straight draw"),
       family,
       mark("One thread per shaft in turn, with a balanced tie-up. An empty loom to paint on."),
       {count_parameter("shafts", mark("Shafts"), "", 1, 64, "4"),
        count_parameter("treadles", mark("Treadles"), "", 1, 64, "4")},
       [](Values v, ClothSize size) {
         return GeneratedWeave{straight_draw(count(v, "shafts"), count(v, "treadles"), size), {}};
       }},
      {"basket",
       mark("Basket"),
       family,
       mark("Plain weave with groups of threads instead of single ones. Softer and more supple than plain weave, for "
            "shirts, blankets and embroidery grounds."),
       {count_parameter("group", mark("Group"), mark("Threads in a group"), 2, 16, "2")},
       [](Values v, ClothSize size) {
         return GeneratedWeave{basket(count(v, "group"), size), {}};
       }},
  };
}

}  // namespace weftlight::weaves
