// The one table of weaves.

#include "draft/generators/table.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numbers>
#include <numeric>

#include "draft/generators/families.h"

namespace weftlight::draft {
namespace {

// ---- values

std::string text(const WeaveValues& values, std::string_view id) {
  for (const auto& [key, value] : values)
    if (key == id) return value;
  return {};
}

int count(const WeaveValues& values, std::string_view id) {
  const std::string value = text(values, id);
  int n = 0;
  std::from_chars(value.data(), value.data() + value.size(), n);
  return n;
}

bool is(const WeaveValues& values, std::string_view id, std::string_view choice) { return text(values, id) == choice; }

OverUnder ratio(const WeaveValues& values, std::string& why) {
  OverUnder order = read_ratio(text(values, "ratio"));
  if (!order.empty()) return order;
  why = quoted(text(values, "ratio")) + " is not a ratio like 2/2; that was taken";
  return {2, 2};
}

std::vector<int> profile(const WeaveValues& values, int blocks, std::string& why, const char* id = "profile") {
  std::vector<int> order = read_profile(text(values, id));
  if (order.empty()) {
    why = quoted(text(values, id)) + " is not a profile like A4 B2; A B was taken";
    order = {0, 1};
  }
  for (int& block : order) {
    if (block < blocks) continue;
    why = "this weave has " + std::to_string(blocks) + " blocks; others began again from A";
    block %= blocks;
  }
  return order;
}

// ---- numbers that several weaves have

WeaveNumber ratio_number(const char* first) {
  return {"ratio",
          "Ratio",
          "Threads the warp passes over, then under, and so on: 2/2, or 3/1/1/3",
          NumberKind::kText,
          first,
          0,
          0,
          {}};
}
WeaveNumber counted(const char* id, const char* label, const char* words, int low, int high, const char* first) {
  return {id, label, words, NumberKind::kCount, first, low, high, {}};
}
WeaveNumber chosen(const char* id, const char* label, const char* words, std::vector<const char*> choices) {
  const char* first = choices.front();
  return {id, label, words, NumberKind::kChoice, first, 0, 0, std::move(choices)};
}
WeaveNumber written(const char* id, const char* label, const char* words, const char* first) {
  return {id, label, words, NumberKind::kText, first, 0, 0, {}};
}
/// What has a step at all: all but 6.
WeaveNumber satin_shafts_number() {
  WeaveNumber n = counted("shafts", "Shafts", "All but 6, which no step makes a satin", 5, 64, "8");
  n.allowed = [](const WeaveNumber& number, const WeaveValues&) {
    std::vector<int> shafts;
    for (int s = number.low; s <= number.high; ++s)
      if (!satin_steps(s).empty()) shafts.push_back(s);
    return shafts;
  };
  return n;
}
WeaveNumber satin_step_number() {
  WeaveNumber n =
      counted("step", "Step", "Those that bind evenly: steps that share no factor with the shafts", 2, 62, "3");
  n.allowed = [](const WeaveNumber&, const WeaveValues& values) { return satin_steps(count(values, "shafts")); };
  return n;
}
WeaveNumber lean_number() { return chosen("lean", "Leans", "Which way the line climbs", {"right", "left"}); }
WeaveNumber profile_number(const char* first) {
  return written("profile", "Profile", "Blocks in their order, with how often each: A4 B2 C1", first);
}

Lean lean(const WeaveValues& v) { return is(v, "lean", "left") ? Lean::kLeft : Lean::kRight; }

// ---- what each weave is made of

/// The picks of a twill taken in an order of their own.
Design broken_twill(const OverUnder& order, const std::vector<int>& breaks, Lean to, ClothSize size) {
  const Draft whole = twill(order, to, {1, 1}).draft;
  Recipe recipe{whole.shafts, {}, {}, {}};
  for (int s = 0; s < whole.shafts; ++s) recipe.threading.push_back(s);
  for (int t = 0; t < whole.treadles; ++t) {
    recipe.tieup.emplace_back();
    for (int s = 0; s < whole.shafts; ++s)
      if (whole.tieup.get(t, s)) recipe.tieup.back().push_back(s);
  }
  for (const int pick : breaks) recipe.treadling.push_back(pick % whole.treadles);
  return make_design(recipe, size);
}

Made make_broken(const WeaveValues& v, ClothSize size) {
  Made made;
  const OverUnder order = ratio(v, made.why);
  const int shafts = std::accumulate(order.begin(), order.end(), 0);
  SequenceRead read = read_sequence(text(v, "order"), shafts);
  if (!read.why.empty()) made.why = read.why;
  if (read.threads.empty()) read.threads = {0, 1, 3, 2};
  made.design = broken_twill(order, read.threads, lean(v), size);
  return made;
}

Made make_satin(const WeaveValues& v, ClothSize size) {
  const int shafts = count(v, "shafts"), wanted = count(v, "step");
  const std::vector<int> steps = satin_steps(shafts);
  if (steps.empty())
    return {twill({shafts - 1, 1}, Lean::kRight, size),
            "there is no satin of " + std::to_string(shafts) + " shafts; the twill stands in its place"};
  const int step = *std::ranges::min_element(steps, {}, [wanted](int s) { return std::abs(s - wanted); });
  Made made{satin(shafts, step, is(v, "face", "weft") ? Face::kBack : Face::kFront, size), {}};
  if (step == wanted) return made;
  made.why = "a satin of " + std::to_string(shafts) + " has the steps";
  for (const int s : steps) made.why.append(" ").append(std::to_string(s));
  made.why += "; " + std::to_string(step) + " was taken";
  return made;
}

/// A pattern line of `ends` ends that swings `height` shafts up and down.
std::vector<int> pattern_line(std::string_view form, int ends, int height) {
  std::vector<int> line;
  for (int e = 0; e < ends; ++e) {
    const double t = static_cast<double>(e) / std::max(ends, 1);
    const double wave = form == "points" ? 1 - std::abs(2 * t - 1)
                        : form == "saw"  ? t
                                         : 0.5 - 0.5 * std::cos(2 * std::numbers::pi * t);
    line.push_back(static_cast<int>(std::lround(wave * height)));
  }
  return line;
}

Made make_network(const WeaveValues& v, ClothSize size) {
  Made made;
  const OverUnder order = ratio(v, made.why);
  const int shafts = std::accumulate(order.begin(), order.end(), 0);
  SequenceRead initial = read_sequence(text(v, "initial"), 16);
  if (!initial.why.empty() || initial.threads.empty()) {
    made.why = quoted(text(v, "initial")) + " is not an initial like 1-4; that was taken";
    initial.threads = {0, 1, 2, 3};
  }
  const int rows = *std::ranges::max_element(initial.threads) + 1;
  initial.threads.resize(static_cast<size_t>(std::max(rows, static_cast<int>(initial.threads.size()))), 0);
  const std::vector<int> draw =
      network_threading(initial.threads, pattern_line(text(v, "line"), count(v, "length"), count(v, "height")), shafts);
  const Draft whole = twill(order, lean(v), {1, 1}).draft;
  Recipe recipe{shafts, draw, {}, {}};
  for (int t = 0; t < whole.treadles; ++t) {
    recipe.tieup.emplace_back();
    for (int s = 0; s < whole.shafts; ++s)
      if (whole.tieup.get(t, s)) recipe.tieup.back().push_back(s);
    recipe.treadling.push_back(t);
  }
  if (is(v, "treadling", "as drawn in")) recipe.treadling = draw;
  made.design = make_design(recipe, size);
  return made;
}

/// Blocks A 1232, B 2343, C 3414, D 4121; between two blocks the first thread of the old one again, so that no two
/// ends of one parity stand together. Based on: Mary Snyder, The Crackle Weave, 1961.
Made make_crackle(const WeaveValues& v, ClothSize size) {
  Made made;
  const std::vector<int> blocks = profile(v, 4, made.why);
  Recipe recipe{4, {}, {{2, 3}, {0, 3}, {0, 1}, {1, 2}, {0, 2}, {1, 3}}, {}};
  for (size_t i = 0; i < blocks.size(); ++i) {
    const int block = blocks[i], next = blocks[(i + 1) % blocks.size()];
    for (const int step : {0, 1, 2, 1}) recipe.threading.push_back((block + step) % 4);
    // Round the blocks the short way.
    const int away = (next - block + 4) % 4;
    for (int k = 0; k < (away == 3 ? 1 : away); ++k) recipe.threading.push_back((block + k) % 4);
  }
  for (const int block : blocks)
    for (int i = 0; i < count(v, "picks"); ++i) {
      recipe.treadling.push_back(block);
      recipe.treadling.push_back(4 + static_cast<int>(recipe.treadling.size()) / 2 % 2);
    }
  made.design = make_design(recipe, size);
  return made;
}

Made make_substitution(const WeaveValues& v, ClothSize size) {
  Made made;
  const auto templates = block_templates();
  const std::string id = text(v, "template");
  const auto found = std::ranges::find_if(templates, [&](const BlockTemplate& t) { return id == t.id; });
  BlockTemplate unit = found != templates.end() ? *found : templates.front();
  const std::string warp = text(v, "warp"), weft = text(v, "weft");
  if (id == "own") unit = {"own", "Own", count(v, "ties"), warp.c_str(), weft.c_str()};
  std::string why;
  const std::vector<int> blocks = profile(v, 8, why);
  made = substituted(unit, blocks, read_profile(text(v, "weft_profile")), size);
  if (made.why.empty()) made.why = why;
  return made;
}

Made make_sections(const WeaveValues& v, ClothSize size) {
  Made made;
  const int shafts = count(v, "shafts");
  Recipe recipe{shafts, {}, {}, {}};
  const auto read = [&](const char* id, int most) {
    SequenceRead r = read_sequence(text(v, id), most);
    if (!r.why.empty() && made.why.empty()) made.why = std::string(id) + ": " + r.why;
    return r.threads.empty() ? std::vector<int>{0} : std::move(r.threads);
  };
  recipe.threading = read("threading", shafts);
  std::string treadle;
  const std::string ties = text(v, "tieup") + "|";
  for (const char c : ties) {
    if (c != '|') {
      treadle += c;
      continue;
    }
    SequenceRead r = read_sequence(treadle, shafts);
    if (!r.why.empty() && made.why.empty()) made.why = "tie-up: " + r.why;
    recipe.tieup.push_back(std::move(r.threads));
    treadle.clear();
    if (recipe.tieup.size() >= static_cast<size_t>(kMaxShafts)) break;
  }
  recipe.treadling = read("treadling", static_cast<int>(recipe.tieup.size()));
  made.design = make_design(recipe, size);
  return made;
}

Made make_sett(const WeaveValues& v, ClothSize size) {
  Made made;
  made.design = twill(ratio(v, made.why), lean(v), size);
  SettRead sett = read_sett(text(v, "sett"));
  if (!sett.why.empty()) made.why = sett.why;
  if (!sett.palette.empty())
    made.design = with_colors(std::move(made.design), sett.palette, sett.stripes, sett.stripes);
  return made;
}

Made make_double(const WeaveValues& v, ClothSize size) {
  Made made;
  const OverUnder order = ratio(v, made.why);
  const bool wide = is(v, "kind", "double width");
  made.design = double_cloth(wide ? DoubleCloth::kDoubleWidth : DoubleCloth::kLayers, order, size);
  return made;
}

template <auto kMake>
Made from_ratio(const WeaveValues& v, ClothSize size) {
  Made made;
  made.design = kMake(ratio(v, made.why), v, size);
  return made;
}

template <auto kMake, int kBlocks>
Made from_profile(const WeaveValues& v, ClothSize size) {
  Made made;
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
         return Made{plain(size), {}};
       }},
      {"straight",
       "Straight draw",
       "Simple",
       "One thread a shaft in turn, with a balanced tie-up: the bare loom to paint on",
       {counted("shafts", "Shafts", "", 1, 64, "4"), counted("treadles", "Treadles", "", 1, 64, "4")},
       [](Values v, ClothSize size) {
         return Made{straight_draw(count(v, "shafts"), count(v, "treadles"), size), {}};
       }},
      {"basket",
       "Basket",
       "Simple",
       "Plain weave with groups of threads in place of one",
       {counted("group", "Group", "Threads that weave as one", 2, 16, "2")},
       [](Values v, ClothSize size) {
         return Made{basket(count(v, "group"), size), {}};
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
         return Made{waffle(count(v, "shafts"), size), {}};
       }},
      {"huck",
       "Huck lace",
       "Texture",
       "Lace spots over a plain ground",
       {},
       [](Values, ClothSize size) {
         return Made{huck_lace(size), {}};
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
         return Made{log_cabin(count(v, "block"), size), {}};
       },
       WeaveColors::kOwn},
      {"houndstooth",
       "Houndstooth",
       "Colour",
       "Four dark, four light, in 2/2 twill",
       {},
       [](Values, ClothSize size) {
         return Made{houndstooth(size), {}};
       },
       WeaveColors::kOwn},
      {"glen_check",
       "Glen check",
       "Colour",
       "Checks of four against checks of two, in 2/2 twill",
       {},
       [](Values, ClothSize size) {
         return Made{glen_check(size), {}};
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

std::string completed(const WeaveNumber& number, const std::string* given) {
  if (!given) return number.first;
  if (number.kind == NumberKind::kText) return *given;
  if (number.kind == NumberKind::kChoice) {
    const bool known = std::ranges::any_of(number.choices, [&](const char* c) { return *given == c; });
    return known ? *given : number.first;
  }
  int n = 0;
  if (std::from_chars(given->data(), given->data() + given->size(), n).ec != std::errc{}) return number.first;
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
  for (const WeaveNumber& number : kind.numbers) {
    const auto found = std::ranges::find_if(given, [&](const auto& v) { return v.first == number.id; });
    values.emplace_back(number.id, completed(number, found != given.end() ? &found->second : nullptr));
  }
  std::ranges::sort(values);
  return values;
}

WeaveValues allowed_values(const WeaveKind& kind, const WeaveValues& given) {
  WeaveValues values = complete_values(kind, given);
  for (const WeaveNumber& number : kind.numbers) {
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
