// Cells and hollows, laces and spots. Units after: Marguerite Porter Davison, A Handweaver's Pattern Book, 1944;
// Madelyn van der Hoogt, The Complete Book of Drafting for Handweavers, 1993.

#include <array>

#include "base/mark.h"
#include "weaves/kinds.h"
#include "weaves/makers.h"
#include "weaves/parameters.h"

namespace weftlight::weaves {

using base::mark;

using Values = const WeaveValues&;

namespace {

constexpr std::array kHoneycomb = {
    BlockTemplate{"", 0, "n(a b)", "aA bB n(aAB bAB)", "0", "p p n(0 0)", 2},
};
constexpr std::array kHuck = {
    BlockTemplate{"", 2, "n(1 a) 1 n(2 b) 2", "n(2A 1bB) 2A n(1B 2aA) 1B"},
};
constexpr std::array kSpotBronson = {
    BlockTemplate{"", 1, "n(1 a)", "n(A 1) aA 1", "0", "1", 2},
};
constexpr std::array kBronsonLace = {kBronsonLaceUnit};
constexpr std::array kCanvas = {
    BlockTemplate{"", 0, "n(a b) a n(c d) c", "n(adAD abBC) adAD n(bcBC cdAD) bcBC"},
};
constexpr std::array kMsAndOs = {
    BlockTemplate{"", 4, "n(1 2) n(3 4)|n(1 3) n(2 4)", "n(12 34 12 34)|n(13 24 13 24)", "0", "1", 2},
};
constexpr std::array kSwivel = {
    BlockTemplate{"", 1, "n(1 a)", "n(A aA 1)", "0", "n(p 0 0)", 2},
};
constexpr std::array kClippedSpots = {
    BlockTemplate{"", 0, "n(a b)", "n(AB aA AB bB)", "0", "n(p 0 p 0)", 2},
};

WeaveParameter pairs_parameter(const char* tip, int high, const char* default_value) {
  return count_parameter("unit_size", mark("Pairs"), tip, 1, high, default_value);
}

}  // namespace

std::vector<WeaveKind> texture_kinds() {
  const char* family = mark("Texture");
  return {
      {"waffle",
       mark("Waffle"),
       family,
       mark("Floats of warp and weft pull the cloth into square cells. Thick and absorbent, for towels and blankets."),
       {count_parameter("shafts", mark("Shafts"), "", 4, 64, "5")},
       [](Values v, ClothSize size) {
         return GeneratedWeave{waffle(count(v, "shafts"), size), {}};
       }},
      {"honeycomb", mark("Honeycomb"), family,
       mark("Cells of plain weave between cells of floats, outlined by two picks of a thick weft that bends round "
            "them. For cushions, bags and hangings; not for hard wear."),
       unit_parameters(kHoneycomb, "A B",
                       {pairs_parameter(mark("Pairs of threads in a cell, across and along"), 16, "4")}),
       from_units<kHoneycomb>, WeaveColors::kByThread},
  };
}

std::vector<WeaveKind> lace_kinds() {
  const char* family = mark("Lace");
  const char* spots = mark("Spots");
  return {
      {"huck", mark("Huck lace"), family,
       mark("Half units of an odd number of threads float in turn over a plain ground. For towels, curtains and light "
            "scarves; use a slightly open sett."),
       unit_parameters(kHuck, "A",
                       {pairs_parameter(mark("Pairs of threads in a half unit and one more: 2 gives five"), 4, "2")}),
       from_units<kHuck>},
      {"bronson", mark("Bronson spots"), family,
       mark("The weft floats in spots over a plain ground; a spot is as wide as the letters of its block in a row. For "
            "table linen and curtains."),
       unit_parameters(kSpotBronson, "A B C B",
                       {pairs_parameter(mark("Pairs of threads in a letter of the profile"), 8, "2")}),
       from_units<kSpotBronson>},
      {"bronson_lace", mark("Atwater-Bronson lace"), family,
       mark("Lace in blocks of any width: each unit ends with a tie that binds its floats. For airy curtains, shawls "
            "and table runners."),
       unit_parameters(kBronsonLace, "A2 B2", {pairs_parameter(mark("Pairs of threads that float in a unit"), 8, "2")}),
       from_units<kBronsonLace>},
      {"canvas", mark("Canvas weave"), family,
       mark("Mock leno: groups of threads draw together and leave holes between them, beside blocks of plain weave. "
            "For curtains, blouses and embroidery grounds."),
       unit_parameters(kCanvas, "A",
                       {pairs_parameter(mark("Pairs of threads in a group and one more: 1 gives three"), 4, "1")}),
       from_units<kCanvas>},
      {"ms_and_os", mark("M's and O's"), family,
       mark("Ribs of grouped threads against plain weave that become round when washed. Four shafts and one shuttle, "
            "for towels and table linen."),
       unit_parameters(kMsAndOs, "A2 B2", {pairs_parameter(mark("Pairs of threads in a rib"), 4, "2")}),
       from_units<kMsAndOs>},
      {"swivel", mark("Swivel"), spots,
       mark("A second weft floats over the figure, and goes with the ground weft through its shed elsewhere. Small "
            "figures on plain cloth, without loose threads on the back."),
       unit_parameters(kSwivel, "A B2 C B2", {pairs_parameter(mark("Pairs of threads in a letter"), 8, "2")}),
       from_units<kSwivel>, WeaveColors::kByThread},
      {"clipped_spots", mark("Clipped spots"), spots,
       mark("A second weft floats over the figure and lies loose on the back between; there it is cut off after "
            "weaving. For dotted blouses and curtains."),
       unit_parameters(kClippedSpots, "A B2", {pairs_parameter(mark("Pairs of threads in a letter"), 8, "2")}),
       from_units<kClippedSpots>, WeaveColors::kByThread},
  };
}

}  // namespace weftlight::weaves
