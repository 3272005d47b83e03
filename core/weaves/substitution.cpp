// Block substitution: a profile gives the order of the blocks, a template the threads of a block.

#include <algorithm>
#include <array>
#include <map>

#include "base/text.h"
#include "weaves/families.h"

namespace weftlight::weaves {

using base::arg, base::fill, base::mark, base::tr;
using draft::kMaxShafts;

namespace {

constexpr std::array kTemplates = {
    BlockTemplate{"summer_winter", mark("Summer and winter"), 2, "1 a 2 a", "1A 12 2A aA"},
    BlockTemplate{"summer_winter_pairs", mark("Summer and winter in pairs"), 2, "1 a 2 a", "1A 12 1A aA 2A 12 2A aA"},
    BlockTemplate{"twill", mark("1/3 and 3/1 twill"), 0, "a b c d", "aBCD bACD cABD dABC"},
    BlockTemplate{"damask", mark("Damask, clean cut"), 0, "a b c d", "aABC bABD cACD dBCD"},
    BlockTemplate{"satin", mark("Damask of 5-shaft satin"), 0, "a b c d e", "aABDE cBCDE eABCE bABCD dACDE"},
    BlockTemplate{"bronson", mark("Bronson lace"), 2, "1 a 1 a 1 2", "2aA 1 2A 1 2A 1"},
    BlockTemplate{"turned_twill", mark("Plain and 3/1 twill"), 0, "a b c d", "abcAC abdBD acdAC bcdBD"},
    BlockTemplate{"double", mark("Double weave, colours exchanged"), 0, "a b c d", "aACD cBCD bABC dABD"},
};

bool is_small(char c) { return c >= 'a' && c <= 'z'; }
bool is_capital(char c) { return c >= 'A' && c <= 'Z'; }

std::vector<std::string> words_of(std::string_view text) {
  std::vector<std::string> words;
  for (const char c : text) {
    if (c == ' ' || c == ',') words.emplace_back();
    else if (words.empty()) words.emplace_back(1, c);
    else words.back() += c;
  }
  std::erase(words, std::string());
  return words;
}

// The shaft of a token in one block; -1 if there is none.
int shaft_of(char token, int ties, int own, int block) {
  if (token >= '1' && token <= '9') return token - '1' < ties ? token - '1' : -1;
  const int letter = is_small(token) ? token - 'a' : is_capital(token) ? token - 'A' : own;
  return letter < own ? ties + block * own + letter : -1;
}

int own_shafts(const BlockTemplate& unit) {
  int own = 0;
  for (const char* text : {unit.warp, unit.weft})
    for (const char* c = text; *c; ++c)
      own = std::max(own, is_small(*c) ? *c - 'a' + 1 : is_capital(*c) ? *c - 'A' + 1 : 0);
  return own;
}

// The shafts lifted by a pick of the template that marks one block.
std::vector<int> lift_of(const std::string& pick, int ties, int own, int blocks, int marked) {
  std::vector<int> shafts;
  for (const char token : pick)
    for (int b = 0; b < blocks; ++b) {
      if (is_small(token) && b != marked) continue;
      if (is_capital(token) && b == marked) continue;
      const int shaft = shaft_of(token, ties, own, b);
      if (shaft >= 0) shafts.push_back(shaft);
    }
  std::ranges::sort(shafts);
  shafts.erase(std::unique(shafts.begin(), shafts.end()), shafts.end());
  return shafts;
}

int blocks_of(const std::vector<int>& a, const std::vector<int>& b) {
  int most = 0;
  for (const auto* profile : {&a, &b})
    for (const int block : *profile) most = std::max(most, block);
  return most + 1;
}

}  // namespace

std::span<const BlockTemplate> block_templates() { return kTemplates; }

GeneratedWeave substituted(const BlockTemplate& unit, const std::vector<int>& warp_profile,
                           const std::vector<int>& weft_profile, ClothSize size) {
  const std::vector<int> warp = warp_profile.empty() ? std::vector<int>{0} : warp_profile;
  const std::vector<int> weft = weft_profile.empty() ? warp : weft_profile;
  const int own = own_shafts(unit), blocks = blocks_of(warp, weft), ties = std::clamp(unit.ties, 0, 9);
  Recipe recipe{ties + own * blocks, {}, {}, {}};
  const std::vector<std::string> ends = words_of(unit.warp), picks = words_of(unit.weft);
  std::string note;
  for (const int block : warp)
    for (const std::string& end : ends) {
      const int shaft = shaft_of(end[0], ties, own, block);
      if (shaft >= 0 && end.size() == 1) recipe.threading.push_back(shaft);
      else note = fill(tr("'{text}' is not a shaft of the template"), arg("text", end));
    }
  std::map<std::vector<int>, int> treadle_of;
  for (const int block : weft)
    for (const std::string& pick : picks) {
      const std::vector<int> lift = lift_of(pick, ties, own, blocks, block);
      const auto [found, added] = treadle_of.try_emplace(lift, static_cast<int>(recipe.tieup.size()));
      if (added) recipe.tieup.push_back(lift);
      recipe.treadling.push_back(found->second);
    }
  if (recipe.shafts < 1 || recipe.shafts > kMaxShafts || recipe.tieup.size() > static_cast<size_t>(kMaxShafts) ||
      recipe.threading.empty() || recipe.treadling.empty())
    return {plain(size), tr("the template makes no weave; plain weave is used instead")};
  return {make_design(recipe, size), note};
}

}  // namespace weftlight::weaves
