// Block substitution: a profile gives the order of the blocks, a unit the threads of a block. Most block weaves are
// such units, and stand as data in the tables of their families.

#include <algorithm>
#include <array>
#include <map>
#include <string>

#include "base/text.h"
#include "weaves/families.h"

namespace weftlight::weaves {

using base::arg, base::fill, base::tr;
using draft::System, draft::Threads, draft::kMaxShafts, draft::kMaxThreads;

namespace {

constexpr size_t kMaxUnitThreads = 512;  // of one unit, repeats expanded
constexpr int kMaxDepth = 8;             // of nested brackets

constexpr std::array kTemplates = {
    kSummerAndWinterUnit,
    BlockTemplate{"summer_winter_pairs", 2, "1 a 2 a", "1A 12 1A aA 2A 12 2A aA", "0", "1 0"},
    BlockTemplate{"twill", 0, "a b c d", "aBCD bACD cABD dABC"},
    BlockTemplate{"damask", 0, "a b c d", "aABC bABD cACD dBCD"},
    BlockTemplate{"satin", 0, "a b c d e", "dACDE aABCD cABDE eBCDE bABCE"},
    kBronsonLaceUnit,
    BlockTemplate{"turned_twill", 0, "a b c d", "abcAC abdBD acdAC bcdBD"},
    kDoubleWeaveUnit,
};

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_small(char c) { return c >= 'a' && c <= 'z'; }
bool is_capital(char c) { return c >= 'A' && c <= 'Z'; }

using Words = std::vector<std::string>;

/// The words of a unit, brackets repeated. What is no repeat is taken as a word, and refused where it names no shaft.
struct UnitReader {
  std::string_view text;
  int n = 1;
  size_t at = 0;

  int times_of(const std::string& word) const {
    if (word == "n") return n;
    int times = 0;
    for (const char c : word)
      times = is_digit(c) ? std::min(times * 10 + (c - '0'), static_cast<int>(kMaxUnitThreads)) : 0;
    return times;
  }
  Words words(int depth) {
    Words out;
    std::string word;
    const auto end_word = [&] {
      if (!word.empty() && out.size() < kMaxUnitThreads) out.push_back(std::move(word));
      word.clear();
    };
    while (at < text.size()) {
      const char c = text[at++];
      if (c == ')' && depth > 0) break;
      if (c == '(' && depth < kMaxDepth) {
        const int times = std::max(times_of(word), 1);
        word.clear();
        const Words inside = words(depth + 1);
        for (int i = 0; i < times && out.size() + inside.size() <= kMaxUnitThreads; ++i)
          out.insert(out.end(), inside.begin(), inside.end());
      } else if (c == ' ' || c == ',') {
        end_word();
      } else {
        word += c;
      }
    }
    end_word();
    return out;
  }
};

/// The units of block A, block B ...; one: all blocks have it.
std::vector<Words> alternatives(std::string_view text, int n) {
  std::vector<Words> out;
  for (size_t at = 0; at <= text.size();) {
    const size_t end = std::min(text.find('|', at), text.size());
    out.push_back(UnitReader{text.substr(at, end - at), n}.words(0));
    at = end + 1;
  }
  return out;
}

int own_shafts(const std::vector<Words>& units) {
  int own = 0;
  for (const Words& unit : units)
    for (const std::string& word : unit)
      for (const char c : word) own = std::max(own, is_small(c) ? c - 'a' + 1 : is_capital(c) ? c - 'A' + 1 : 0);
  return own;
}

int last_block(const std::vector<int>& blocks) { return blocks.empty() ? 0 : *std::ranges::max_element(blocks); }

/// A template read for a number of blocks.
struct ReadTemplate {
  std::vector<Words> ends, picks;
  int ties = 0, own = 0, blocks = 1;

  int shafts() const { return ties + own * blocks; }
  static const Words& of_block(const std::vector<Words>& units, int block) {
    return units[static_cast<size_t>(block) % units.size()];
  }
  /// The shaft that a sign names in a block; -1 if there is none.
  int shaft_of(char sign, int block) const {
    if (sign >= '1' && sign <= '9') return sign - '1' < ties ? sign - '1' : -1;
    const int letter = is_small(sign) ? sign - 'a' : is_capital(sign) ? sign - 'A' : own;
    return letter < own ? ties + block * own + letter : -1;
  }
  /// The shafts that a pick lifts where `marked` is the pattern block.
  std::vector<int> lift_of(const std::string& pick, int marked) const {
    std::vector<int> shafts;
    for (const char sign : pick)
      for (int b = 0; b < blocks; ++b) {
        if ((is_small(sign) && b != marked) || (is_capital(sign) && b == marked)) continue;
        if (const int shaft = shaft_of(sign, b); shaft >= 0) shafts.push_back(shaft);
      }
    std::ranges::sort(shafts);
    shafts.erase(std::unique(shafts.begin(), shafts.end()), shafts.end());
    return shafts;
  }
};

/// The colours of a unit over the threads of a profile.
std::vector<char> colors_of(const char* colors, int n, const std::vector<Words>& units,
                            const std::vector<int>& profile) {
  const Words order = UnitReader{colors, n}.words(0);
  std::vector<char> out;
  for (const int block : profile) {
    const size_t threads = ReadTemplate::of_block(units, block).size();
    for (size_t i = 0; i < threads; ++i) out.push_back(order[i % order.size()][0]);
    if (out.size() >= static_cast<size_t>(kMaxThreads)) break;
  }
  return out;
}

Design with_unit_colors(Design design, System system, const std::vector<char>& colors) {
  if (colors.empty()) return design;
  Threads& threads = design.draft.threads(system);
  for (size_t i = 0; i < threads.color.size(); ++i) threads.color[i] = colors[i % colors.size()] == '0' ? 0 : 1;
  std::vector<bool> marked;
  for (const char c : colors) marked.push_back(c == 'p');
  if (std::ranges::find(marked, true) == marked.end()) return design;
  return with_pattern_yarn(std::move(design), system, marked);
}

/// The threading of the profile; the first word that names no shaft in `unknown`.
std::vector<int> threading_of(const ReadTemplate& units, const std::vector<int>& profile, std::string& unknown) {
  std::vector<int> threading;
  for (const int block : profile) {
    for (const std::string& end : ReadTemplate::of_block(units.ends, block)) {
      const int shaft = units.shaft_of(end[0], block);
      if (shaft >= 0 && end.size() == 1) threading.push_back(shaft);
      else if (unknown.empty()) unknown = end;
    }
    if (threading.size() >= static_cast<size_t>(kMaxThreads)) break;
  }
  return threading;
}

void add_treadling(const ReadTemplate& units, const std::vector<int>& profile, Recipe& recipe) {
  std::map<std::vector<int>, int> treadle_of;
  std::map<int, std::vector<int>> treadles_of_block;
  for (const int block : profile) {
    const auto [unit, first] = treadles_of_block.try_emplace(block);
    if (first)
      for (const std::string& pick : ReadTemplate::of_block(units.picks, block)) {
        const std::vector<int> lift = units.lift_of(pick, block);
        const auto [found, added] = treadle_of.try_emplace(lift, static_cast<int>(recipe.tieup.size()));
        if (added) recipe.tieup.push_back(lift);
        unit->second.push_back(found->second);
      }
    recipe.treadling.insert(recipe.treadling.end(), unit->second.begin(), unit->second.end());
    if (recipe.treadling.size() >= static_cast<size_t>(kMaxThreads)) break;
  }
}

bool is_weave(const Recipe& recipe) {
  return recipe.shafts >= 1 && recipe.shafts <= kMaxShafts && recipe.tieup.size() <= static_cast<size_t>(kMaxShafts) &&
         !recipe.threading.empty() && !recipe.treadling.empty();
}

}  // namespace

std::span<const BlockTemplate> block_templates() { return kTemplates; }

GeneratedWeave substituted(const BlockTemplate& unit, const Profile& profile, ClothSize size, int n, bool turn) {
  const std::vector<int> warp = profile.warp.empty() ? std::vector<int>{0} : profile.warp;
  const std::vector<int> weft = profile.weft.empty() ? warp : profile.weft;
  ReadTemplate units{alternatives(unit.warp, n), alternatives(unit.weft, n), std::clamp(unit.ties, 0, 9), 0, 1};
  units.own = std::max(own_shafts(units.ends), own_shafts(units.picks));
  units.blocks = std::max(last_block(warp), last_block(weft)) + 1;
  std::string unknown;
  Recipe recipe{units.shafts(), threading_of(units, warp, unknown), {}, {}};
  add_treadling(units, weft, recipe);
  if (!is_weave(recipe)) return {plain(size), tr("the template makes no weave; plain weave is used instead")};
  GeneratedWeave made{make_design(turn ? turned(recipe) : recipe, size), {}};
  if (!unknown.empty()) made.note = fill(tr("'{text}' is not a shaft of the template"), arg("text", unknown));
  const std::vector<char> of_ends = colors_of(unit.warp_colors, n, units.ends, warp),
                          of_picks = colors_of(unit.weft_colors, n, units.picks, weft);
  made.design = with_unit_colors(std::move(made.design), System::kWarp, turn ? of_picks : of_ends);
  made.design = with_unit_colors(std::move(made.design), System::kWeft, turn ? of_ends : of_picks);
  return made;
}

GeneratedWeave make_units(std::span<const BlockTemplate> units, const WeaveValues& values, ClothSize size) {
  const std::string kind = text(values, "kind");
  const auto found = std::ranges::find_if(units, [&](const BlockTemplate& u) { return kind == u.id; });
  const BlockTemplate& unit = found != units.end() ? *found : units.front();
  const auto variants = static_cast<int>(std::ranges::count(std::string_view(unit.warp), '|')) + 1;
  Noted<std::vector<int>> warp = profile(values, variants > 1 ? variants : kMaxBlocks, "profile", unit.least_blocks);
  Profile whole{std::move(warp.value)};
  std::string note = std::move(warp.note);
  if (!text(values, "weft_profile").empty()) {
    Noted<std::vector<int>> weft = profile(values, last_block(whole.warp) + 1, "weft_profile");
    whole.weft = std::move(weft.value);
    if (note.empty()) note = std::move(weft.note);
  }
  GeneratedWeave made =
      substituted(unit, whole, size, std::max(count(values, "unit_size"), 1), is(values, "turned", "yes"));
  if (made.note.empty()) made.note = std::move(note);
  return made;
}

}  // namespace weftlight::weaves
