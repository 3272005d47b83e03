// Twills and satins.

#include "base/mark.h"
#include "weaves/kinds.h"
#include "weaves/makers.h"
#include "weaves/parameters.h"

namespace weftlight::weaves {

using base::mark;

using Values = const WeaveValues&;

namespace {

/// A satin exists for any number of shafts from 5 but 6.
WeaveParameter satin_shafts_parameter() {
  WeaveParameter n = count_parameter("shafts", mark("Shafts"), mark("5 or more; no satin exists on 6"), 5, 64, "8");
  n.allowed = [](const WeaveParameter& parameter, const WeaveValues&) {
    std::vector<int> shafts;
    for (int s = parameter.low; s <= parameter.high; ++s)
      if (!satin_steps(s).empty()) shafts.push_back(s);
    return shafts;
  };
  return n;
}

WeaveParameter satin_step_parameter() {
  WeaveParameter n = count_parameter(
      "step", mark("Step"), mark("Steps without a common factor with the shafts: they bind evenly"), 2, 62, "3");
  n.allowed = [](const WeaveParameter&, const WeaveValues& values) { return satin_steps(count(values, "shafts")); };
  return n;
}

WeaveParameter corkscrew_shafts_parameter() {
  WeaveParameter n =
      count_parameter("shafts", mark("Shafts"), mark("An odd number: half of them and a half rise"), 5, 31, "9");
  n.allowed = [](const WeaveParameter& parameter, const WeaveValues&) {
    std::vector<int> shafts;
    for (int s = parameter.low; s <= parameter.high; s += 2) shafts.push_back(s);
    return shafts;
  };
  return n;
}

}  // namespace

std::vector<WeaveKind> twill_kinds() {
  const char* family = mark("Twill");
  return {
      {"twill",
       mark("Twill"),
       family,
       mark("Each pick shifts by one end, which draws a diagonal line. Supple and hard-wearing: denim, gabardine, "
            "most suitings."),
       {ratio_parameter("2/2"), lean_parameter()},
       from_ratio<[](const OverUnder& order, Values v, ClothSize size) { return twill(order, lean(v), size); }>},
      {"broken_twill",
       mark("Broken twill"),
       family,
       mark("The picks of a twill in an order that breaks the diagonal. The cloth of a twill without its line; on four "
            "shafts it approaches a satin."),
       {ratio_parameter("3/1"), lean_parameter(),
        text_parameter("order", mark("Order"), mark("Picks of the twill, from 1"), "1 2 4 3")},
       make_broken},
      {"point_twill",
       mark("Point twill"),
       family,
       mark("The diagonal reverses: chevrons, or diamonds woven as drawn in. For coats, towels and blankets."),
       {ratio_parameter("2/2"), choice_parameter("treadling", mark("Treadling"), mark("Straight gives chevrons"),
                                                 {mark("straight"), mark("as drawn in")})},
       from_ratio<[](const OverUnder& order, Values v, ClothSize size) {
         return pointed_twill(order, is(v, "treadling", "as drawn in"), size);
       }>},
      {"herringbone",
       mark("Herringbone"),
       family,
       mark("Bands of twill in alternate directions, with a clean break. The break keeps the floats short; for coats "
            "and suits."),
       {ratio_parameter("2/2"), count_parameter("band", mark("Band"), mark("Ends in a band"), 2, 400, "8")},
       from_ratio<[](const OverUnder& order, Values v, ClothSize size) {
         return herringbone(order, count(v, "band"), size);
       }>},
      {"corkscrew",
       mark("Corkscrew twill"),
       family,
       mark("One system covers both faces in cords of a steep twill, and hides the other. Dense and strong, for "
            "worsted suits, uniforms and bands."),
       {corkscrew_shafts_parameter(), face_parameter(), lean_parameter()},
       [](Values v, ClothSize size) {
         const Face face = is(v, "face", "weft") ? Face::kBack : Face::kFront;
         return GeneratedWeave{corkscrew(count(v, "shafts"), face, lean(v), size), {}};
       }},
      {"advancing_twill",
       mark("Advancing twill"),
       family,
       mark("Straight draws that each start further on. The diagonal becomes a figure, large for the shafts that it "
            "takes."),
       {ratio_parameter("3/1/1/3"), count_parameter("run", mark("Run"), mark("Ends in a draw"), 2, 64, "5"),
        count_parameter("advance", mark("Advance"), mark("Shafts by which each draw advances"), 1, 32, "1")},
       from_ratio<[](const OverUnder& order, Values v, ClothSize size) {
         return advancing_twill(order, count(v, "run"), count(v, "advance"), size);
       }>},
      {"undulating_twill",
       mark("Undulating twill"),
       family,
       mark("The diagonal steepens and flattens like a wave. For scarves and throws, where longer floats do no harm."),
       {ratio_parameter("2/2"),
        count_parameter("widest", mark("Widest"), mark("Largest number of successive ends on one shaft"), 1, 8, "3"),
        choice_parameter("treadling", mark("Treadling"), mark("As drawn in gives stars"),
                         {mark("straight"), mark("as drawn in")})},
       from_ratio<[](const OverUnder& order, Values v, ClothSize size) {
         return undulating_twill(order, count(v, "widest"), is(v, "treadling", "as drawn in"), size);
       }>},
      {"network",
       mark("Network draft"),
       family,
       mark("A curved pattern line on a network that keeps floats short. Free curves from a loom of few shafts."),
       {ratio_parameter("3/1/1/1/1/1"), lean_parameter(),
        text_parameter("initial", mark("Initial"), mark("The threading unit that the network repeats"), "1-4"),
        choice_parameter("line", mark("Line"), mark("The pattern line"), {mark("wave"), mark("points"), mark("saw")}),
        count_parameter("length", mark("Length"), mark("Ends in the line"), 4, 4000, "64"),
        count_parameter("height", mark("Height"), mark("Shafts that it rises; beyond the last shaft it starts again"),
                        1, 400, "16"),
        choice_parameter("treadling", mark("Treadling"), "", {mark("as drawn in"), mark("straight")})},
       make_network},
      {"satin",
       mark("Satin"),
       mark("Satin"),
       mark("Long floats with scattered binding points. Smooth and lustrous, for linings, dresses and damask."),
       {satin_shafts_parameter(), satin_step_parameter(), face_parameter()},
       make_satin},
  };
}

}  // namespace weftlight::weaves
