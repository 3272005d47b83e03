// The one table of weaves.

#include "draft/generators/table.h"

#include <algorithm>
#include <charconv>
#include <cstdlib>

#include "draft/generators/families.h"
#include "draft/generators/weave_values.h"

namespace weftlight::draft {
namespace {

// ---- numbers that several weaves have

WeaveParameter ratio_number(const char* first) {
  return {"ratio",
          "Ratio",
          "Threads the warp passes over, then under, and so on: 2/2, or 3/1/1/3",
          ParameterKind::kText,
          first,
          0,
          0,
          {}};
}
WeaveParameter counted(const char* id, const char* label, const char* words, int low, int high, const char* first) {
  return {id, label, words, ParameterKind::kCount, first, low, high, {}};
}
WeaveParameter chosen(const char* id, const char* label, const char* words, std::vector<const char*> choices) {
  const char* first = choices.front();
  return {id, label, words, ParameterKind::kChoice, first, 0, 0, std::move(choices)};
}
WeaveParameter written(const char* id, const char* label, const char* words, const char* first) {
  return {id, label, words, ParameterKind::kText, first, 0, 0, {}};
}
/// What has a step at all: all but 6.
WeaveParameter satin_shafts_number() {
  WeaveParameter n = counted("shafts", "Shafts", "All but 6, which no step makes a satin", 5, 64, "8");
  n.allowed = [](const WeaveParameter& number, const WeaveValues&) {
    std::vector<int> shafts;
    for (int s = number.low; s <= number.high; ++s)
      if (!satin_steps(s).empty()) shafts.push_back(s);
    return shafts;
  };
  return n;
}
WeaveParameter satin_step_number() {
  WeaveParameter n =
      counted("step", "Step", "Those that bind evenly: steps that share no factor with the shafts", 2, 62, "3");
  n.allowed = [](const WeaveParameter&, const WeaveValues& values) { return satin_steps(count(values, "shafts")); };
  return n;
}
WeaveParameter lean_number() { return chosen("lean", "Leans", "Which way the line climbs", {"right", "left"}); }
WeaveParameter profile_number(const char* first) {
  return written("profile", "Profile", "Blocks in their order, with how often each: A4 B2 C1", first);
}

template <auto kMake>
GeneratedWeave from_ratio(const WeaveValues& v, ClothSize size) {
  GeneratedWeave made;
  made.design = kMake(ratio(v, made.why), v, size);
  return made;
}

template <auto kMake, int kBlocks>
GeneratedWeave from_profile(const WeaveValues& v, ClothSize size) {
  GeneratedWeave made;
  made.design = kMake(profile(v, kBlocks, made.why), v, size);
  return made;
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
       "Plain",
       "Simple",
       "Over one, under one",
       {},
       [](Values, ClothSize size) {
         return GeneratedWeave{plain(size), {}};
       }},
      {"straight",
       "Straight draw",
       "Simple",
       "One thread a shaft in turn, with a balanced tie-up: the bare loom to paint on",
       {counted("shafts", "Shafts", "", 1, 64, "4"), counted("treadles", "Treadles", "", 1, 64, "4")},
       [](Values v, ClothSize size) {
         return GeneratedWeave{straight_draw(count(v, "shafts"), count(v, "treadles"), size), {}};
       }},
      {"basket",
       "Basket",
       "Simple",
       "Plain weave with groups of threads in place of one",
       {counted("group", "Group", "Threads that weave as one", 2, 16, "2")},
       [](Values v, ClothSize size) {
         return GeneratedWeave{basket(count(v, "group"), size), {}};
       }},
      {"twill",
       "Twill",
       "Twill",
       "Each pick one end further: a diagonal line",
       {ratio_number("2/2"), lean_number()},
       from_ratio<[](const OverUnder& order, Values v, ClothSize size) { return twill(order, lean(v), size); }>},
      {"broken_twill",
       "Broken twill",
       "Twill",
       "The picks of a twill in an order that breaks its line",
       {ratio_number("3/1"), lean_number(), written("order", "Order", "Picks of the twill, from 1", "1 2 4 3")},
       make_broken},
      {"point_twill",
       "Point twill",
       "Twill",
       "The diagonal turns back: chevrons, or diamonds woven as drawn in",
       {ratio_number("2/2"), chosen("treadling", "Treadling", "Straight gives chevrons", {"straight", "as drawn in"})},
       from_ratio<[](const OverUnder& order, Values v, ClothSize size) {
         return pointed_twill(order, is(v, "treadling", "as drawn in"), size);
       }>},
      {"herringbone",
       "Herringbone",
       "Twill",
       "Bands of twill that lean to either side, with a clean break",
       {ratio_number("2/2"), counted("band", "Band", "Ends of a band", 2, 400, "8")},
       from_ratio<[](const OverUnder& order, Values v, ClothSize size) {
         return herringbone(order, count(v, "band"), size);
       }>},
      {"advancing_twill",
       "Advancing twill",
       "Twill",
       "Straight draws that each begin further on",
       {ratio_number("3/1/1/3"), counted("run", "Run", "Ends of a draw", 2, 64, "5"),
        counted("advance", "Advance", "Shafts further", 1, 32, "1")},
       from_ratio<[](const OverUnder& order, Values v, ClothSize size) {
         return advancing_twill(order, count(v, "run"), count(v, "advance"), size);
       }>},
      {"undulating_twill",
       "Undulating twill",
       "Twill",
       "The diagonal steepens and flattens like a wave",
       {ratio_number("2/2"), counted("widest", "Widest", "Ends in turn on one shaft, at the most", 1, 8, "3"),
        chosen("treadling", "Treadling", "As drawn in gives stars", {"straight", "as drawn in"})},
       from_ratio<[](const OverUnder& order, Values v, ClothSize size) {
         return undulating_twill(order, count(v, "widest"), is(v, "treadling", "as drawn in"), size);
       }>},
      {"network",
       "Network draft",
       "Twill",
       "A curved line drawn over a network, so that floats stay short",
       {ratio_number("3/1/1/1/1/1"), lean_number(),
        written("initial", "Initial", "The figure that the network repeats", "1-4"),
        chosen("line", "Line", "The pattern line", {"wave", "points", "saw"}),
        counted("length", "Length", "Ends of the line", 4, 4000, "64"),
        counted("height", "Height", "Shafts it climbs; more than there are goes round", 1, 400, "16"),
        chosen("treadling", "Treadling", "", {"as drawn in", "straight"})},
       make_network},
      {"satin",
       "Satin",
       "Satin",
       "Long floats, bound as far apart as the step puts them",
       {satin_shafts_number(), satin_step_number(),
        chosen("face", "Face", "What floats on the front", {"warp", "weft"})},
       make_satin},
      {"waffle",
       "Waffle",
       "Texture",
       "Floats draw the cloth into cells",
       {counted("shafts", "Shafts", "", 4, 64, "5")},
       [](Values v, ClothSize size) {
         return GeneratedWeave{waffle(count(v, "shafts"), size), {}};
       }},
      {"huck",
       "Huck lace",
       "Texture",
       "Lace spots over a plain ground",
       {},
       [](Values, ClothSize size) {
         return GeneratedWeave{huck_lace(size), {}};
       }},
      {"overshot",
       "Overshot",
       "Blocks",
       "Pattern weft floats in blocks over tabby",
       {profile_number("A B C D C B"), counted("block", "Block", "Ends of a block", 2, 64, "4")},
       from_profile<
           [](const std::vector<int>& b, Values v, ClothSize size) { return overshot(b, count(v, "block"), size); }, 4>,
       WeaveColors::kPattern},
      {"crackle",
       "Crackle",
       "Blocks",
       "Three-thread blocks with soft edges, two blocks woven at once",
       {profile_number("A2 B2 C2 D2 C2 B2"), counted("picks", "Picks", "Pattern picks of a block", 1, 64, "4")},
       make_crackle,
       WeaveColors::kPattern},
      {"summer_winter",
       "Summer and winter",
       "Blocks",
       "Blocks in reverse on the other face, tied down evenly",
       {profile_number("A B C D C B")},
       from_profile<[](const std::vector<int>& b, Values, ClothSize size) { return summer_and_winter(b, size); }, 26>,
       WeaveColors::kPattern},
      {"damask",
       "Twill damask",
       "Blocks",
       "Warp-faced against weft-faced twill in blocks",
       {profile_number("A2 B2 A B")},
       from_profile<[](const std::vector<int>& b, Values, ClothSize size) { return twill_damask(b, size); }, 2>},
      {"substitution",
       "Block substitution",
       "Blocks",
       "A profile woven by a template of your own or of the shelf",
       {chosen("template", "Template", "What a block is made of", template_choices()), profile_number("A4 B2 A2 B4"),
        written("weft_profile", "Weft profile", "Blocks that the picks weave; empty: as drawn in", ""),
        counted("ties", "Shared shafts", "Of an own template: shafts that all blocks share", 0, 9, "2"),
        written("warp", "Own warp unit", "Ends of a block: 1.. are shared shafts, a, b its own", "1 a 2 a"),
        written("weft", "Own weft unit", "Picks: small letters lift the marked blocks, capitals the others",
                "1A 12 2A aA")},
       make_substitution},
      {"double",
       "Double weave",
       "Layers",
       "Two layers at once, or one folded at a selvedge",
       {ratio_number("1/1"), chosen("kind", "Kind", "", {"two layers", "double width"})},
       make_double},
      {"sections",
       "Sections",
       "In words",
       "Threading and treadling put together from sections and repeats",
       {counted("shafts", "Shafts", "", 1, 64, "8"),
        written("threading", "Threading", "Shafts, runs and repeats: 1-8 3x(1 2) 8-1", "2x(1-8) 2x(8-1)"),
        written("tieup", "Tie-up", "Shafts of each treadle, between bars",
                "1 2 5 6|2 3 6 7|3 4 7 8|1 4 5 8|1 2 5 6|2 3 6 7|3 4 7 8|1 4 5 8"),
        written("treadling", "Treadling", "Treadles, runs and repeats", "1-8")},
       make_sections},
      {"shadow",
       "Shadow weave",
       "Colour",
       "Dark and light in turn: the order makes the lines",
       {profile_number("A B C D C B")},
       from_profile<[](const std::vector<int>& b, Values, ClothSize size) { return shadow_weave(b, size); }, 4>,
       WeaveColors::kOwn},
      {"log_cabin",
       "Log cabin",
       "Colour",
       "Plain weave of two colours whose order is turned over",
       {counted("block", "Block", "Threads of a block", 2, 400, "8")},
       [](Values v, ClothSize size) {
         return GeneratedWeave{log_cabin(count(v, "block"), size), {}};
       },
       WeaveColors::kOwn},
      {"houndstooth",
       "Houndstooth",
       "Colour",
       "Four dark, four light, in 2/2 twill",
       {},
       [](Values, ClothSize size) {
         return GeneratedWeave{houndstooth(size), {}};
       },
       WeaveColors::kOwn},
      {"glen_check",
       "Glen check",
       "Colour",
       "Checks of four against checks of two, in 2/2 twill",
       {},
       [](Values, ClothSize size) {
         return GeneratedWeave{glen_check(size), {}};
       },
       WeaveColors::kOwn},
      {"sett",
       "Tartan",
       "Colour",
       "Stripes by a written sett, in warp and weft",
       {ratio_number("2/2"), lean_number(),
        written("sett", "Sett", "Colours and threads: R8 K4 G24; with strokes, R/8 K4 G/24, it turns back",
                "B/24 K4 B4 K4 B4 K20 G20 K2 W4 K2 G20 K20 B20 R/4")},
       make_sett,
       WeaveColors::kOwn},
  };
  return kKinds;
}

std::string completed(const WeaveParameter& number, const std::string* given) {
  if (!given) return number.default_value;
  if (number.kind == ParameterKind::kText) return *given;
  if (number.kind == ParameterKind::kChoice) {
    const bool known = std::ranges::any_of(number.choices, [&](const char* c) { return *given == c; });
    return known ? *given : number.default_value;
  }
  int n = 0;
  if (std::from_chars(given->data(), given->data() + given->size(), n).ec != std::errc{}) return number.default_value;
  return std::to_string(std::clamp(n, number.low, number.high));
}

}  // namespace

std::span<const WeaveKind> weave_kinds() { return all_kinds(); }

const WeaveKind* find_weave(std::string_view id) {
  const auto found = std::ranges::find_if(all_kinds(), [id](const WeaveKind& kind) { return id == kind.id; });
  return found != all_kinds().end() ? &*found : nullptr;
}

WeaveValues complete_values(const WeaveKind& kind, const WeaveValues& given) {
  WeaveValues values;
  for (const WeaveParameter& number : kind.parameters) {
    const auto found = std::ranges::find_if(given, [&](const auto& v) { return v.first == number.id; });
    values.emplace_back(number.id, completed(number, found != given.end() ? &found->second : nullptr));
  }
  std::ranges::sort(values);
  return values;
}

WeaveValues allowed_values(const WeaveKind& kind, const WeaveValues& given) {
  WeaveValues values = complete_values(kind, given);
  for (const WeaveParameter& number : kind.parameters) {
    if (number.allowed == nullptr) continue;
    const int wanted = count(values, number.id);
    const auto away = [wanted](int n) { return std::abs(n - wanted); };
    const std::vector<int> all = number.allowed(number, values);
    const auto best = std::ranges::min_element(all, {}, away);
    const auto at = std::ranges::find(values, std::string(number.id), &WeaveValues::value_type::first);
    if (best != all.end()) at->second = std::to_string(*best);
  }
  return values;
}

}  // namespace weftlight::draft
