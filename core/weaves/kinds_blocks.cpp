// Weaves of blocks, tied weaves and parallel threadings. Units after: Madelyn van der Hoogt, The Complete Book of
// Drafting for Handweavers, 1993; John Becker, Pattern and Loom, 1987.

#include <array>

#include "base/mark.h"
#include "weaves/kinds.h"
#include "weaves/makers.h"
#include "weaves/parameters.h"

namespace weftlight::weaves {

using base::mark;

using Values = const WeaveValues&;

namespace {

constexpr std::array kSummerAndWinter = {
    renamed(mark("one by one"), kSummerAndWinterUnit),
    BlockTemplate{mark("in pairs"), 2, "1 a 2 a", "1A 12 2A aA 2A 12 1A aA", "0", "1 0"},
    BlockTemplate{mark("in opposite pairs"), 2, "1 a 2 a", "2A 12 1A aA 1A 12 2A aA", "0", "1 0"},
    BlockTemplate{mark("in columns"), 2, "1 a 2 a", "1A 12 1A aA", "0", "1 0"},
};
constexpr std::array kTaquete = {
    BlockTemplate{mark("plain"), 2, "1 a 2 a", "1A 1a 2A 2a", "0", "1 0"},
    BlockTemplate{mark("twill"), 3, "1 a 2 a 3 a", "1A 1a 2A 2a 3A 3a", "0", "1 0"},
};
constexpr std::array kBeiderwand = {
    BlockTemplate{"", 2, "1 n(a b) 2 n(b a)", "1bB 1AB 2aA 2AB", "0", "0 p"},
};

WeaveParameter template_parameter() {
  std::vector<const char*> ids;
  for (const BlockTemplate& t : block_templates()) ids.push_back(t.id);
  ids.push_back("own");
  WeaveParameter n = choice_parameter("template", mark("Template"), mark("The threads of a block"), std::move(ids));
  n.names = {mark("summer and winter"),
             mark("summer and winter in pairs"),
             mark("twill"),
             mark("damask"),
             mark("satin"),
             mark("Bronson lace"),
             mark("turned twill"),
             mark("double weave"),
             mark("your own")};
  return n;
}
WeaveParameter of_own_template(WeaveParameter n) {
  n.used = [](const WeaveValues& values) { return is(values, "template", "own"); };
  return n;
}

WeaveParameter length_parameter() {
  return count_parameter("length", mark("Length"), mark("Ends of each warp in the line"), 4, 2000, "48");
}
WeaveParameter height_parameter(const char* default_value) {
  return count_parameter("height", mark("Height"), mark("Shafts that it rises; beyond the last shaft it starts again"),
                         1, 400, default_value);
}
WeaveParameter line_parameter() {
  return choice_parameter("line", mark("Line"), mark("The pattern line"), {mark("wave"), mark("points"), mark("saw")});
}
WeaveParameter line_treadling_parameter(std::vector<const char*> choices) {
  return choice_parameter("treadling", mark("Treadling"), mark("As drawn in closes the curves to rings"),
                          std::move(choices));
}
WeaveParameter jin_shafts_parameter() {
  WeaveParameter n = count_parameter("shafts", mark("Shafts"), mark("A multiple of four"), 4, 64, "8");
  n.allowed = [](const WeaveParameter& parameter, const WeaveValues&) {
    std::vector<int> shafts;
    for (int s = parameter.low; s <= parameter.high; s += 4) shafts.push_back(s);
    return shafts;
  };
  return n;
}

}  // namespace

std::vector<WeaveKind> block_kinds() {
  const char* family = mark("Blocks");
  return {
      {"overshot",
       mark("Overshot"),
       family,
       mark("A thick pattern weft floats in blocks over a tabby ground, with half tones between. The coverlet weave, "
            "with large figures from few shafts."),
       {profile_parameter("A B C D C B"),
        count_parameter("block", mark("Block"), mark("Ends in a block, with the one that it shares with the next"), 2,
                        64, "4"),
        choice_parameter(
            "fashion", mark("Fashion"),
            mark("Star weaves the blocks in the order of the threading; rose exchanges A with B, C with D"),
            {mark("star"), mark("rose")}),
        choice_parameter("treadling", mark("Treadling"),
                         mark("As drawn in weaves block by block; tromp as writ has a pick for each pair of ends"),
                         {mark("as drawn in"), mark("tromp as writ")}),
        count_parameter("picks", mark("Picks"), mark("Pattern picks in a block as drawn in; 0: half of its ends"), 0,
                        64, "0")},
       make_overshot,
       WeaveColors::kPattern},
      {"crackle",
       mark("Crackle"),
       family,
       mark("Blocks of three-thread units with soft edges; two blocks weave at once. Blends of many colours without "
            "long floats, for upholstery, coverlets and hangings."),
       {profile_parameter("A2 B2 C2 D2 C2 B2"),
        count_parameter("picks", mark("Picks"), mark("Pattern picks in a block"), 1, 64, "4")},
       make_crackle,
       WeaveColors::kPattern},
      {"damask",
       mark("Twill damask"),
       family,
       mark("Blocks of warp-faced and weft-faced twill with a clean cut between them. Figures that show by their sheen "
            "alone, for table linen."),
       {profile_parameter("A2 B2 A B")},
       from_profile<[](const std::vector<int>& b, Values, ClothSize size) { return twill_damask(b, size); }, 2>},
      {"substitution",
       mark("Block substitution"),
       family,
       mark("A profile woven with a ready-made template or one of your own. For any block weave that you can write as "
            "one unit."),
       {template_parameter(), profile_parameter("A4 B2 A2 B4"), weft_profile_parameter(),
        count_parameter("unit_size", mark("Repeats in a unit"), mark("Of what stands in n(...)"), 1, 16, "2"),
        turned_parameter(),
        of_own_template(count_parameter("ties", mark("Shared shafts"),
                                        mark("Your own template: shafts that all blocks share"), 0, 9, "2")),
        of_own_template(text_parameter(
            "warp", mark("Own warp unit"),
            mark("Ends of a block: 1, 2 ... are shared shafts, a, b ... its own; 3(1 a) and n(1 a) repeat"),
            "1 a 2 a")),
        of_own_template(
            text_parameter("weft", mark("Own weft unit"),
                           mark("Picks: small letters lift shafts of the marked block, capitals those of the others"),
                           "1A 12 2A aA"))},
       make_substitution,
       WeaveColors::kByThread},
  };
}

std::vector<WeaveKind> tied_kinds() {
  const char* family = mark("Tied");
  return {
      {"summer_winter", mark("Summer and winter"), family,
       mark("Two-faced blocks of a pattern weft that two tie-down shafts bind in even points. Dark on one face where "
            "light on the other, for coverlets, rugs and cushions."),
       unit_parameters(kSummerAndWinter, "A B C D C B"), from_units<kSummerAndWinter>, WeaveColors::kByThread},
      {"taquete", mark("Taquet\xC3\xA9 and samitum"), family,
       mark("Two wefts change faces block by block and cover the warp, bound in plain weave or in a twill. For rugs "
            "and hangings; turned, it is warp-faced and takes one shuttle."),
       unit_parameters(kTaquete, "A2 B2"), from_units<kTaquete>, WeaveColors::kByThread},
      {"beiderwand", mark("Beiderwand"), family,
       mark("A plain ground whose pattern weft is bound by every fifth end, so that it lies in ribbed blocks. For "
            "coverlets, curtains and bags."),
       unit_parameters(
           kBeiderwand, "A2 B2",
           {count_parameter("unit_size", mark("Pairs"),
                            mark("Pairs of ground ends between two tie-down ends: 2 gives four to one"), 1, 4, "2")}),
       from_units<kBeiderwand>, WeaveColors::kByThread},
  };
}

std::vector<WeaveKind> parallel_kinds() {
  const char* family = mark("Echo");
  return {
      {"echo",
       mark("Echo weave"),
       family,
       mark("Two warps of different colours follow one line, the second some shafts above the first. Curves whose "
            "colours shine through each other, for scarves and shawls."),
       {ratio_parameter("4/4"), lean_parameter(), line_parameter(), length_parameter(), height_parameter("24"),
        count_parameter("interval", mark("Interval"), mark("Shafts from the first warp to the second"), 1, 64, "4"),
        line_treadling_parameter({mark("straight"), mark("as drawn in")})},
       make_echo,
       WeaveColors::kByThread},
      {"jin",
       mark("Jin"),
       family,
       mark("Turned taquet\xC3\xA9 on two parallel warps: a pattern pick and a binding pick in turn keep every float "
            "to three. Curves in warp colours with one shuttle, for scarves and jackets."),
       {jin_shafts_parameter(), line_parameter(), length_parameter(), height_parameter("24"),
        line_treadling_parameter({mark("as drawn in"), mark("straight")})},
       make_jin,
       WeaveColors::kByThread},
  };
}

}  // namespace weftlight::weaves
