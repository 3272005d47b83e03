// Cloths of several layers.

#include <array>

#include "base/mark.h"
#include "weaves/kinds.h"
#include "weaves/makers.h"
#include "weaves/parameters.h"

namespace weftlight::weaves {

using base::mark;

namespace {

constexpr std::array kDoubleBlocks = {kDoubleWeaveUnit};
// Two cloths: a b with the first picks, c d with the second. In the marked block the first lies on top.
constexpr std::array kDeflected = {
    BlockTemplate{"", 0, "n(a b) n(c d)", "n(aACD bBCD) n(abcC abdD)", "n(0 0) n(1 1)", "n(0 0) n(1 1)", 2},
};

}  // namespace

std::vector<WeaveKind> layer_kinds() {
  const char* family = mark("Layers");
  return {
      {"double",
       mark("Double weave"),
       family,
       mark("Two or more cloths at once, one above the other: separate, as a tube, or folded into one of double width. "
            "For bags, quilting and cloth wider than the loom; drop one end of a plain-weave tube so that the weave "
            "continues all round."),
       {ratio_parameter("1/1"),
        choice_parameter("kind", mark("Kind"),
                         mark("Double width is folded at the selvedges, once for each additional layer"),
                         {mark("separate layers"), mark("tube"), mark("double width")}),
        count_parameter("layers", mark("Layers"), mark("Three layers folded make triple width; a tube has two"), 2, 4,
                        "2")},
       make_double,
       WeaveColors::kByThread},
      {"double_blocks", mark("Double weave blocks"), family,
       mark("Two plain cloths, light and dark, that change places block by block; each block is a pocket. For "
            "hangings, blankets and cushions with the figure on both faces."),
       unit_parameters(kDoubleBlocks, "A4 B4"), from_units<kDoubleBlocks>, WeaveColors::kByThread},
      {"stitched",
       mark("Stitched double cloth"),
       family,
       mark("Two cloths joined by single crossings, where floats hide them. One thick, warm cloth with two different "
            "faces, for coats and blankets."),
       {ratio_parameter("2/2"),
        choice_parameter("stitch", mark("Stitch"), mark("Which ends bind the two cloths"),
                         {mark("lower ends rise"), mark("upper ends sink")}),
        count_parameter("stitches", mark("Stitches"), mark("Stitches in a repeat of the twill, at most one per end"), 1,
                        16, "2")},
       make_stitched,
       WeaveColors::kByThread},
      {"deflected", mark("Deflected double weave"), family,
       mark("Stripes of two plain cloths float over each other and change places block by block. Washing bends the "
            "floats into curves; for scarves of two yarns that shrink differently."),
       unit_parameters(kDeflected, "A B A",
                       {count_parameter("unit_size", mark("Pairs"), mark("Pairs of threads in a stripe"), 1, 8, "2")}),
       from_units<kDeflected>, WeaveColors::kByThread},
  };
}

}  // namespace weftlight::weaves
