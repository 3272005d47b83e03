#include "session/weaves.h"

#include <algorithm>
#include <cstdlib>
#include <numeric>

namespace weftlight::session {
namespace {

using Numbers = std::array<int, kWeaveNumbers>;

const std::vector<Rgb> kTwoTones = {{0.93f, 0.90f, 0.84f}, {0.16f, 0.25f, 0.42f}};

/// Light warp, dark weft, where the weave itself has no colours.
Design two_tone(Design design) { return with_colors(std::move(design), kTwoTones, {{0, 1}}, {{1, 1}}); }

/// Pattern wefts dark, the tabby between them as the warp.
Design pattern_tone(Design design) { return with_colors(std::move(design), kTwoTones, {{0, 1}}, {{1, 1}, {0, 1}}); }

// Orders of blocks that make a whole figure.
const std::vector<int> kRose = {0, 1, 2, 3, 2, 1};
const std::vector<int> kBlocks = {0, 0, 1, 1, 0, 1};

constexpr int kRepeatSought = 512;  // threads in which a repeat is looked for

/// The smallest p after which everything is the same again; 0: none up to half of `count`.
template <class Same>
int period(int count, Same same) {
  for (int p = 1; p <= count / 2; ++p) {
    int i = 0;
    while (i + p < count && same(i, i + p)) ++i;
    if (i + p == count) return p;
  }
  return 0;
}

/// What has a step at all: all but 6.
std::vector<int> satin_shafts(const Numbers&) {
  std::vector<int> shafts;
  for (int n = 5; n <= 24; ++n)
    if (!satin_steps(n).empty()) shafts.push_back(n);
  return shafts;
}

std::vector<int> steps_of(const Numbers& n) { return satin_steps(n[0]); }

const Weave kWeaves[] = {
    {"Straight draw",
     "One thread a shaft in turn, with a balanced tie-up: the bare loom to paint on",
     {{{"Shafts", 1, 64, 4}, {"Treadles", 1, 64, 4}, {}}},
     [](const Numbers& n, ClothSize size) { return straight_draw(n[0], n[1], size); }},
    {"Plain", "Over one, under one", {}, [](const Numbers&, ClothSize size) { return two_tone(plain(size)); }},
    {"Basket",
     "Plain weave with groups of threads in place of one",
     {{{"Group", 2, 8, 2}, {}, {}}},
     [](const Numbers& n, ClothSize size) { return two_tone(basket(n[0], size)); }},
    {"Twill",
     "Each pick one end further: a diagonal line",
     {{{"Over", 1, 12, 2}, {"Under", 1, 12, 2}, {}}},
     [](const Numbers& n, ClothSize size) {
       return two_tone(twill({n[0], n[1]}, Lean::kRight, size));
     }},
    {"Satin",
     "Long warp floats, bound as far apart as the step puts them",
     {{{"Shafts", 5, 24, 8, satin_shafts}, {"Step", 2, 22, 3, steps_of}, {}}},
     [](const Numbers& n, ClothSize size) { return two_tone(satin(n[0], n[1], Face::kFront, size)); }},
    {"Sateen",
     "Satin with the weft on the face",
     {{{"Shafts", 5, 24, 8, satin_shafts}, {"Step", 2, 22, 3, steps_of}, {}}},
     [](const Numbers& n, ClothSize size) { return two_tone(satin(n[0], n[1], Face::kBack, size)); }},
    {"Point twill",
     "The diagonal turns back: chevrons",
     {{{"Over", 1, 12, 2}, {"Under", 1, 12, 2}, {}}},
     [](const Numbers& n, ClothSize size) {
       return two_tone(pointed_twill({n[0], n[1]}, false, size));
     }},
    {"Diamonds",
     "Point threading, woven as drawn in",
     {{{"Over", 1, 12, 2}, {"Under", 1, 12, 2}, {}}},
     [](const Numbers& n, ClothSize size) {
       return two_tone(pointed_twill({n[0], n[1]}, true, size));
     }},
    {"Herringbone",
     "Bands of twill that lean to either side, with a clean break",
     {{{"Over", 1, 12, 2}, {"Under", 1, 12, 2}, {"Band", 2, 64, 8}}},
     [](const Numbers& n, ClothSize size) {
       return two_tone(herringbone({n[0], n[1]}, n[2], size));
     }},
    {"Advancing twill",
     "Straight draws that each begin further on",
     {{{"Run", 2, 32, 5}, {"Advance", 1, 16, 1}, {}}},
     [](const Numbers& n, ClothSize size) {
       return two_tone(advancing_twill({3, 1, 1, 3}, n[0], n[1], size));
     }},
    {"Undulating twill",
     "The diagonal steepens and flattens like a wave",
     {{{"Widest", 1, 8, 3}, {}, {}}},
     [](const Numbers& n, ClothSize size) {
       return two_tone(undulating_twill({2, 2}, n[0], false, size));
     }},
    {"Waffle",
     "Floats draw the cloth into cells",
     {{{"Shafts", 4, 16, 5}, {}, {}}},
     [](const Numbers& n, ClothSize size) { return two_tone(waffle(n[0], size)); }},
    {"Huck lace",
     "Lace spots over a plain ground",
     {},
     [](const Numbers&, ClothSize size) { return two_tone(huck_lace(size)); }},
    {"Overshot",
     "Pattern weft floats in blocks over tabby",
     {{{"Block", 2, 16, 4}, {}, {}}},
     [](const Numbers& n, ClothSize size) { return pattern_tone(overshot(kRose, n[0], size)); }},
    {"Summer and winter",
     "Blocks in reverse on the other face, tied down evenly",
     {},
     [](const Numbers&, ClothSize size) {
       return pattern_tone(summer_and_winter({0, 1, 2, 3, 2, 1}, size));
     }},
    {"Twill damask",
     "Warp-faced against weft-faced twill in blocks",
     {},
     [](const Numbers&, ClothSize size) { return two_tone(twill_damask(kBlocks, size)); }},
    {"Shadow weave",
     "Dark and light in turn: the order makes the lines",
     {},
     [](const Numbers&, ClothSize size) {
       return shadow_weave({0, 1, 2, 3, 2, 1}, size);
     }},
    {"Log cabin",
     "Plain weave of two colours whose order is turned over",
     {{{"Block", 2, 64, 8}, {}, {}}},
     [](const Numbers& n, ClothSize size) { return log_cabin(n[0], size); }},
    {"Houndstooth",
     "Four dark, four light, in 2/2 twill",
     {},
     [](const Numbers&, ClothSize size) { return houndstooth(size); }},
    {"Glen check",
     "Checks of four against checks of two, in 2/2 twill",
     {},
     [](const Numbers&, ClothSize size) { return glen_check(size); }},
};

}  // namespace

std::span<const Weave> weaves() { return kWeaves; }

Numbers first_numbers(const Weave& weave) {
  Numbers n{};
  for (size_t i = 0; i < n.size(); ++i) n[i] = weave.numbers[i].start;
  return n;
}

Numbers valid_numbers(const Weave& weave, Numbers n) {
  for (size_t i = 0; i < n.size(); ++i) {
    const WeaveNumber& number = weave.numbers[i];
    n[i] = std::clamp(n[i], number.min, number.max);
    if (number.choices == nullptr) continue;
    const std::vector<int> all = number.choices(n);
    const auto nearer = [wanted = n[i]](int a, int b) { return std::abs(a - wanted) < std::abs(b - wanted); };
    if (const auto best = std::min_element(all.begin(), all.end(), nearer); best != all.end()) n[i] = *best;
  }
  return n;
}

ClothSize repeat_of(const Weave& weave, const Numbers& n) {
  const Draft d = weave.make(n, {kRepeatSought, kRepeatSought}).draft;
  const auto same_rows = [](const BitMatrix& m, int i, int j) { return std::ranges::equal(m.row(i), m.row(j)); };
  const auto same_look = [](const Threads& t, int i, int j) {
    const auto a = static_cast<size_t>(i), b = static_cast<size_t>(j);
    return t.color[a] == t.color[b] && t.yarn[a] == t.yarn[b];
  };
  const BitMatrix& lifts = d.drive == Drive::kLiftplan ? d.liftplan : d.treadling;
  return {period(d.ends(), [&](int i, int j) { return same_rows(d.threading, i, j) && same_look(d.warp, i, j); }),
          period(d.picks(), [&](int i, int j) { return same_rows(lifts, i, j) && same_look(d.weft, i, j); })};
}

ClothSize whole_repeats(ClothSize repeat, ClothSize about) {
  const auto whole = [](int one, int wanted) {
    return one <= 0 ? wanted : std::max(1, (wanted + one / 2) / one) * one;
  };
  return {whole(repeat.ends, about.ends), whole(repeat.picks, about.picks)};
}

std::vector<int> satin_steps(int shafts) {
  std::vector<int> steps;
  for (int step = 2; step + 1 < shafts; ++step)
    if (std::gcd(step, shafts) == 1) steps.push_back(step);
  return steps;
}

Design straight_draw(int shafts, int treadles, ClothSize size) {
  Design design;
  design.draft = blank_draft(size.ends, size.picks, shafts, treadles);
  Draft& d = design.draft;
  d.palette = kTwoTones;
  for (int end = 0; end < size.ends; ++end) d.threading.set(end, end % shafts, true);
  for (int pick = 0; pick < size.picks; ++pick) d.treadling.set(pick, pick % treadles, true);
  for (int treadle = 0; treadle < treadles; ++treadle)
    for (int k = 0; k < std::max(1, shafts / 2); ++k) d.tieup.set(treadle, (treadle + k) % shafts, true);
  std::fill(d.weft.color.begin(), d.weft.color.end(), 1);
  return design;
}

}  // namespace weftlight::session
