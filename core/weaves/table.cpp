// The table of weaves.

#include "weaves/table.h"

#include <algorithm>
#include <charconv>
#include <cstdlib>

#include "base/mark.h"
#include "weaves/families.h"
#include "weaves/makers.h"

namespace weftlight::weaves {

using base::mark;

namespace {

// ---- parameters of several weaves

WeaveParameter ratio_parameter(const char* default_value) {
  return {"ratio",
          mark("Ratio"),
          mark("Threads the warp passes over, then under, and so on: 2/2, or 3/1/1/3"),
          ParameterKind::kText,
          default_value,
          0,
          0,
          {}};
}
WeaveParameter count_parameter(const char* id, const char* label, const char* tip, int low, int high,
                               const char* default_value) {
  return {id, label, tip, ParameterKind::kCount, default_value, low, high, {}};
}
WeaveParameter choice_parameter(const char* id, const char* label, const char* tip, std::vector<const char*> choices) {
  const char* default_value = choices.front();
  return {id, label, tip, ParameterKind::kChoice, default_value, 0, 0, std::move(choices)};
}
WeaveParameter text_parameter(const char* id, const char* label, const char* tip, const char* default_value) {
  return {id, label, tip, ParameterKind::kText, default_value, 0, 0, {}};
}
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
WeaveParameter lean_parameter() {
  return choice_parameter("lean", mark("Direction"), mark("Direction of the twill line"),
                          {mark("right"), mark("left")});
}
WeaveParameter profile_parameter(const char* default_value) {
  return text_parameter("profile", mark("Profile"), mark("Order of the blocks, each with its length: A4 B2 C1"),
                        default_value);
}

template <auto kMake>
GeneratedWeave from_ratio(const WeaveValues& v, ClothSize size) {
  auto [order, note] = ratio(v);
  return {kMake(order, v, size), std::move(note)};
}

template <auto kMake, int kBlocks>
GeneratedWeave from_profile(const WeaveValues& v, ClothSize size) {
  auto [blocks, note] = profile(v, kBlocks);
  return {kMake(blocks, v, size), std::move(note)};
}

std::vector<const char*> template_choices() {
  std::vector<const char*> ids;
  for (const BlockTemplate& t : block_templates()) ids.push_back(t.id);
  ids.push_back("own");
  return ids;
}

const std::vector<WeaveKind>& all_kinds() {
  using Values = const WeaveValues&;
  static const std::vector<WeaveKind> kKinds = {
      {"plain",
       mark("Plain"),
       mark("Simple"),
       mark("Over one, under one"),
       {},
       [](Values, ClothSize size) {
         return GeneratedWeave{plain(size), {}};
       }},
      {"straight",
       mark("Straight draw"),
       mark("Simple"),
       mark("One thread per shaft in turn, with a balanced tie-up: an empty loom to paint on"),
       {count_parameter("shafts", mark("Shafts"), "", 1, 64, "4"),
        count_parameter("treadles", mark("Treadles"), "", 1, 64, "4")},
       [](Values v, ClothSize size) {
         return GeneratedWeave{straight_draw(count(v, "shafts"), count(v, "treadles"), size), {}};
       }},
      {"basket",
       mark("Basket"),
       mark("Simple"),
       mark("Plain weave with groups of threads instead of single ones"),
       {count_parameter("group", mark("Group"), mark("Threads in a group"), 2, 16, "2")},
       [](Values v, ClothSize size) {
         return GeneratedWeave{basket(count(v, "group"), size), {}};
       }},
      {"twill",
       mark("Twill"),
       mark("Twill"),
       mark("Each pick shifts by one end: a diagonal line"),
       {ratio_parameter("2/2"), lean_parameter()},
       from_ratio<[](const OverUnder& order, Values v, ClothSize size) { return twill(order, lean(v), size); }>},
      {"broken_twill",
       mark("Broken twill"),
       mark("Twill"),
       mark("The picks of a twill in an order that breaks the diagonal"),
       {ratio_parameter("3/1"), lean_parameter(),
        text_parameter("order", mark("Order"), mark("Picks of the twill, from 1"), "1 2 4 3")},
       make_broken},
      {"point_twill",
       mark("Point twill"),
       mark("Twill"),
       mark("The diagonal reverses: chevrons, or diamonds woven as drawn in"),
       {ratio_parameter("2/2"), choice_parameter("treadling", mark("Treadling"), mark("Straight gives chevrons"),
                                                 {mark("straight"), mark("as drawn in")})},
       from_ratio<[](const OverUnder& order, Values v, ClothSize size) {
         return pointed_twill(order, is(v, "treadling", "as drawn in"), size);
       }>},
      {"herringbone",
       mark("Herringbone"),
       mark("Twill"),
       mark("Bands of twill in alternate directions, with a clean break"),
       {ratio_parameter("2/2"), count_parameter("band", mark("Band"), mark("Ends in a band"), 2, 400, "8")},
       from_ratio<[](const OverUnder& order, Values v, ClothSize size) {
         return herringbone(order, count(v, "band"), size);
       }>},
      {"advancing_twill",
       mark("Advancing twill"),
       mark("Twill"),
       mark("Straight draws that each start further on"),
       {ratio_parameter("3/1/1/3"), count_parameter("run", mark("Run"), mark("Ends in a draw"), 2, 64, "5"),
        count_parameter("advance", mark("Advance"), mark("Shafts by which each draw advances"), 1, 32, "1")},
       from_ratio<[](const OverUnder& order, Values v, ClothSize size) {
         return advancing_twill(order, count(v, "run"), count(v, "advance"), size);
       }>},
      {"undulating_twill",
       mark("Undulating twill"),
       mark("Twill"),
       mark("The diagonal steepens and flattens like a wave"),
       {ratio_parameter("2/2"),
        count_parameter("widest", mark("Widest"), mark("Largest number of successive ends on one shaft"), 1, 8, "3"),
        choice_parameter("treadling", mark("Treadling"), mark("As drawn in gives stars"),
                         {mark("straight"), mark("as drawn in")})},
       from_ratio<[](const OverUnder& order, Values v, ClothSize size) {
         return undulating_twill(order, count(v, "widest"), is(v, "treadling", "as drawn in"), size);
       }>},
      {"network",
       mark("Network draft"),
       mark("Twill"),
       mark("A curved pattern line on a network that keeps floats short"),
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
       mark("Long floats with scattered binding points"),
       {satin_shafts_parameter(), satin_step_parameter(),
        choice_parameter("face", mark("Face"), mark("System that floats on the front"), {mark("warp"), mark("weft")})},
       make_satin},
      {"waffle",
       mark("Waffle"),
       mark("Texture"),
       mark("Floats pull the cloth into cells"),
       {count_parameter("shafts", mark("Shafts"), "", 4, 64, "5")},
       [](Values v, ClothSize size) {
         return GeneratedWeave{waffle(count(v, "shafts"), size), {}};
       }},
      {"huck",
       mark("Huck lace"),
       mark("Texture"),
       mark("Lace spots over a plain ground"),
       {},
       [](Values, ClothSize size) {
         return GeneratedWeave{huck_lace(size), {}};
       }},
      {"overshot",
       mark("Overshot"),
       mark("Blocks"),
       mark("Pattern weft floats in blocks over a tabby ground"),
       {profile_parameter("A B C D C B"), count_parameter("block", mark("Block"), mark("Ends in a block"), 2, 64, "4")},
       from_profile<
           [](const std::vector<int>& b, Values v, ClothSize size) { return overshot(b, count(v, "block"), size); }, 4>,
       WeaveColors::kPattern},
      {"crackle",
       mark("Crackle"),
       mark("Blocks"),
       mark("Blocks of three-thread units with soft edges; two blocks weave at once"),
       {profile_parameter("A2 B2 C2 D2 C2 B2"),
        count_parameter("picks", mark("Picks"), mark("Pattern picks in a block"), 1, 64, "4")},
       make_crackle,
       WeaveColors::kPattern},
      {"summer_winter",
       mark("Summer and winter"),
       mark("Blocks"),
       mark("Two-faced blocks with evenly spaced tie-down threads"),
       {profile_parameter("A B C D C B")},
       from_profile<[](const std::vector<int>& b, Values, ClothSize size) { return summer_and_winter(b, size); }, 26>,
       WeaveColors::kPattern},
      {"damask",
       mark("Twill damask"),
       mark("Blocks"),
       mark("Blocks of warp-faced and weft-faced twill"),
       {profile_parameter("A2 B2 A B")},
       from_profile<[](const std::vector<int>& b, Values, ClothSize size) { return twill_damask(b, size); }, 2>},
      {"substitution",
       mark("Block substitution"),
       mark("Blocks"),
       mark("A profile woven with a ready-made template or one of your own"),
       {choice_parameter("template", mark("Template"), mark("The threads of a block"), template_choices()),
        profile_parameter("A4 B2 A2 B4"),
        text_parameter("weft_profile", mark("Weft profile"), mark("Order of the weft blocks; empty: as drawn in"), ""),
        count_parameter("ties", mark("Shared shafts"), mark("Your own template: shafts that all blocks share"), 0, 9,
                        "2"),
        text_parameter("warp", mark("Own warp unit"),
                       mark("Ends of a block: 1, 2 ... are shared shafts, a, b ... its own"), "1 a 2 a"),
        text_parameter("weft", mark("Own weft unit"),
                       mark("Picks: small letters lift shafts of the marked block, capitals those of the others"),
                       "1A 12 2A aA")},
       make_substitution},
      {"double",
       mark("Double weave"),
       mark("Layers"),
       mark("Two layers at once, or one of double width folded at a selvedge"),
       {ratio_parameter("1/1"), choice_parameter("kind", mark("Kind"), "", {mark("two layers"), mark("double width")})},
       make_double},
      {"sections",
       mark("Sections"),
       mark("Written"),
       mark("Threading and treadling written as runs and repeats"),
       {count_parameter("shafts", mark("Shafts"), "", 1, 64, "8"),
        text_parameter("threading", mark("Threading"), mark("Shafts, runs and repeats: 1-8 3x(1 2) 8-1"),
                       "2x(1-8) 2x(8-1)"),
        text_parameter("tieup", mark("Tie-up"), mark("Shafts of each treadle, separated by bars"),
                       "1 2 5 6|2 3 6 7|3 4 7 8|1 4 5 8|1 2 5 6|2 3 6 7|3 4 7 8|1 4 5 8"),
        text_parameter("treadling", mark("Treadling"), mark("Treadles, runs and repeats"), "1-8")},
       make_sections},
      {"shadow",
       mark("Shadow weave"),
       mark("Colour"),
       mark("Dark and light threads in turn; their order makes the lines"),
       {profile_parameter("A B C D C B")},
       from_profile<[](const std::vector<int>& b, Values, ClothSize size) { return shadow_weave(b, size); }, 4>,
       WeaveColors::kOwn},
      {"log_cabin",
       mark("Log cabin"),
       mark("Colour"),
       mark("Plain weave of two colours in turn; their order is reversed in each block"),
       {count_parameter("block", mark("Block"), mark("Threads in a block"), 2, 400, "8")},
       [](Values v, ClothSize size) {
         return GeneratedWeave{log_cabin(count(v, "block"), size), {}};
       },
       WeaveColors::kOwn},
      {"houndstooth",
       mark("Houndstooth"),
       mark("Colour"),
       mark("Four dark and four light threads in 2/2 twill"),
       {},
       [](Values, ClothSize size) {
         return GeneratedWeave{houndstooth(size), {}};
       },
       WeaveColors::kOwn},
      {"glen_check",
       mark("Glen check"),
       mark("Colour"),
       mark("Stripes of four and stripes of two threads, in 2/2 twill"),
       {},
       [](Values, ClothSize size) {
         return GeneratedWeave{glen_check(size), {}};
       },
       WeaveColors::kOwn},
      {"sett",
       mark("Tartan"),
       mark("Colour"),
       mark("Stripes of a written sett, in warp and weft"),
       {ratio_parameter("2/2"), lean_parameter(),
        text_parameter("sett", mark("Sett"),
                       mark("Colours and threads: R8 K4 G24; with strokes, R/8 K4 G/24, it reverses at the pivots"),
                       "B/24 K4 B4 K4 B4 K20 G20 K2 W4 K2 G20 K20 B20 R/4")},
       make_sett,
       WeaveColors::kOwn},
  };
  return kKinds;
}

std::string completed(const WeaveParameter& parameter, const std::string* given) {
  if (!given) return parameter.default_value;
  if (parameter.kind == ParameterKind::kText) return *given;
  if (parameter.kind == ParameterKind::kChoice) {
    const bool known = std::ranges::any_of(parameter.choices, [&](const char* c) { return *given == c; });
    return known ? *given : parameter.default_value;
  }
  int n = 0;
  if (std::from_chars(given->data(), given->data() + given->size(), n).ec != std::errc{})
    return parameter.default_value;
  return std::to_string(std::clamp(n, parameter.low, parameter.high));
}

}  // namespace

std::span<const WeaveKind> weave_kinds() { return all_kinds(); }

const WeaveKind* find_weave(std::string_view id) {
  const auto found = std::ranges::find_if(all_kinds(), [id](const WeaveKind& kind) { return id == kind.id; });
  return found != all_kinds().end() ? &*found : nullptr;
}

WeaveValues complete_values(const WeaveKind& kind, const WeaveValues& given) {
  WeaveValues values;
  for (const WeaveParameter& parameter : kind.parameters) {
    const auto found = std::ranges::find_if(given, [&](const auto& v) { return v.first == parameter.id; });
    values.emplace_back(parameter.id, completed(parameter, found != given.end() ? &found->second : nullptr));
  }
  std::ranges::sort(values);
  return values;
}

WeaveValues allowed_values(const WeaveKind& kind, const WeaveValues& given) {
  WeaveValues values = complete_values(kind, given);
  for (const WeaveParameter& parameter : kind.parameters) {
    if (parameter.allowed == nullptr) continue;
    const int wanted = count(values, parameter.id);
    const auto away = [wanted](int n) { return std::abs(n - wanted); };
    const std::vector<int> all = parameter.allowed(parameter, values);
    const auto best = std::ranges::min_element(all, {}, away);
    const auto at = std::ranges::find(values, std::string(parameter.id), &WeaveValues::value_type::first);
    if (best != all.end()) at->second = std::to_string(*best);
  }
  return values;
}

}  // namespace weftlight::weaves
