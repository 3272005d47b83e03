// Weaves as a weaver writes them, and colours in plain weave and twill.

#include "base/mark.h"
#include "weaves/kinds.h"
#include "weaves/makers.h"
#include "weaves/parameters.h"

namespace weftlight::weaves {

using base::mark;

using Values = const WeaveValues&;

std::vector<WeaveKind> written_kinds() {
  const char* family = mark("Written");
  return {
      {"sections",
       mark("Sections"),
       family,
       mark("Threading and treadling written as runs and repeats. For a draft out of a book or a notebook."),
       {count_parameter("shafts", mark("Shafts"), "", 1, 64, "8"),
        text_parameter("threading", mark("Threading"), mark("Shafts, runs and repeats: 1-8 3x(1 2) 8-1"),
                       "2x(1-8) 2x(8-1)"),
        text_parameter("tieup", mark("Tie-up"), mark("Shafts of each treadle, separated by bars"),
                       "1 2 5 6|2 3 6 7|3 4 7 8|1 4 5 8|1 2 5 6|2 3 6 7|3 4 7 8|1 4 5 8"),
        text_parameter("treadling", mark("Treadling"), mark("Treadles, runs and repeats"), "1-8")},
       make_sections},
      {"iso",
       mark("Weave code"),
       family,
       mark("A plain weave, twill or satin by its code of ISO 9354, as mills and standards write it. The command "
            "'info' names the code of a draft that has one."),
       {text_parameter("code", mark("Code"),
                       mark("Kind, picks over and under, ends that weave alike, step: 10-01 01-01-00 is plain weave, "
                            "20-02 02-01-01 a 2/2 twill, 30-04 01-01-02 a satin"),
                       "20-02 02-01-01")},
       make_iso},
  };
}

std::vector<WeaveKind> color_kinds() {
  const char* family = mark("Colour");
  return {
      {"shadow",
       mark("Shadow weave"),
       family,
       mark("Dark and light threads in turn, whose order makes fine lines along or across. Sharp figures on a firm "
            "cloth, for scarves, coats and place mats."),
       {profile_parameter("A B C D C B")},
       from_profile<[](const std::vector<int>& b, Values, ClothSize size) { return shadow_weave(b, size); }, 4>,
       WeaveColors::kOwn},
      {"log_cabin",
       mark("Log cabin"),
       family,
       mark("Plain weave of two colours in turn; their order is reversed in each block. Figures on two shafts, for "
            "place mats, rugs and scarves."),
       {count_parameter("block", mark("Block"), mark("Threads in a block"), 2, 400, "8")},
       [](Values v, ClothSize size) {
         return GeneratedWeave{log_cabin(count(v, "block"), size), {}};
       },
       WeaveColors::kOwn},
      {"houndstooth",
       mark("Houndstooth"),
       family,
       mark("A twill in stripes of dark and light threads that make pointed checks. Stripes as wide as the repeat of "
            "the twill give the tooth; for coats, jackets and scarves."),
       {ratio_parameter("2/2"),
        count_parameter("threads", mark("Threads"), mark("Threads of each colour"), 1, 64, "4")},
       from_ratio<[](const OverUnder& order, Values v, ClothSize size) {
         return houndstooth(order, count(v, "threads"), size);
       }>,
       WeaveColors::kOwn},
      {"glen_check",
       mark("Glen check"),
       family,
       mark("Checks of coarse stripes against checks of fine ones, in a twill. With an overcheck it is the Prince of "
            "Wales check; for suits and coats."),
       {ratio_parameter("2/2"),
        count_parameter("threads", mark("Coarse"), mark("Threads of a coarse stripe"), 1, 16, "4"),
        count_parameter("pairs", mark("Coarse pairs"), mark("Pairs of a dark and a light coarse stripe"), 1, 40, "6"),
        count_parameter("fine_threads", mark("Fine"), mark("Threads of a fine stripe"), 1, 16, "2"),
        count_parameter("fine_pairs", mark("Fine pairs"), mark("Pairs of a dark and a light fine stripe"), 1, 40, "12"),
        count_parameter("overcheck", mark("Overcheck"), mark("Threads of a third colour in each coarse check"), 0, 8,
                        "0")},
       make_glen_check,
       WeaveColors::kOwn},
      {"sett",
       mark("Tartan"),
       family,
       mark("Stripes of a written sett, in warp and weft. For kilts, scarves and blankets of a clan or of your own."),
       {ratio_parameter("2/2"), lean_parameter(),
        text_parameter("sett", mark("Sett"),
                       mark("Colours and threads: R8 K4 G24; with strokes, R/8 K4 G/24, it reverses at the pivots; "
                            "between dots, ...R8 K4 G24..., it does not"),
                       "B/24 K4 B4 K4 B4 K20 G20 K2 W4 K2 G20 K20 B20 R/4")},
       make_sett,
       WeaveColors::kOwn},
  };
}

}  // namespace weftlight::weaves
