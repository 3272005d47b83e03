// The rows of the table of weaves against drafts written by hand from the structures that handbooks describe, and over
// the ranges of their parameters: sound cloth, and no more than they say.

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <map>
#include <numeric>
#include <optional>
#include <random>

#include "../hand_drafts.h"
#include "analysis/floats.h"
#include "analysis/weave_layers.h"
#include "weaves/families.h"
#include "weaves/table.h"

namespace weftlight::weaves {

using analysis::WeaveLayer, analysis::longest_floats, analysis::weave_layers;
using design::Design, design::Rows, design::is_consistent, design::text_of;
using draft::BitMatrix, draft::Draft, draft::Face, draft::drawdown;

namespace {

/// One repeat, as rows.
Rows repeat_rows(const char* weave, const WeaveValues& values) {
  const WeaveKind& kind = *find_weave(weave);
  return text_of(drawdown(new_draft(kind, values, repeat_of(kind, values)).design.draft));
}

Rows times(const Rows& rows, int n) {
  Rows out;
  for (int i = 0; i < n; ++i) out.insert(out.end(), rows.begin(), rows.end());
  return out;
}
Rows joined(Rows a, const Rows& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

TEST(WeaveKinds, HuckFloatsOverHalfUnitsInTurn) {
  EXPECT_EQ(repeat_rows("huck", {}),
            (Rows{"0000010101", "1010101010", "0000010101", "1010101010", "0000010101",  // the weft floats over five
                  "1010100000", "0101010101", "1010100000", "0101010101", "1010100000"}));
}

TEST(WeaveKinds, BronsonSpotsAndLace) {
  const Rows spot_a = {"00000101", "10101010", "00000101", "10101010", "01010101", "10101010"},
             spot_b = {"01010000", "10101010", "01010000", "10101010", "01010101", "10101010"};
  EXPECT_EQ(repeat_rows("bronson", {{"profile", "A B"}}), joined(spot_a, spot_b));
  EXPECT_EQ(repeat_rows("bronson_lace", {{"profile", "A"}}),
            (Rows{"010101", "101010", "000001", "101010", "000001", "101010"}))
      << "the last end of the unit binds the floats";
}

TEST(WeaveKinds, CanvasGroupsThreeThreads) {
  EXPECT_EQ(repeat_rows("canvas", {}), (Rows{"101010", "111000", "101010", "010101", "000111", "010101"}));
}

TEST(WeaveKinds, MsAndOsSetRibsAgainstPlainWeave) {
  const Rows ribs_left = {"1111000010101010", "0000111101010101"},
             ribs_right = {"1010101011110000", "0101010100001111"};
  EXPECT_EQ(repeat_rows("ms_and_os", {{"profile", "A B"}}), joined(times(ribs_left, 4), times(ribs_right, 4)));
}

TEST(WeaveKinds, Spots) {
  EXPECT_EQ(repeat_rows("swivel", {{"profile", "A B"}, {"unit_size", "1"}}),
            (Rows{"0001", "0101", "1010", "0100", "0101", "1010"}));
  EXPECT_EQ(repeat_rows("clipped_spots", {{"profile", "A B"}, {"unit_size", "1"}}),
            (Rows{"0011", "1010", "0011", "0101", "1100", "1010", "1100", "0101"}));
}

TEST(WeaveKinds, HoneycombOutlinesItsCellsWithTabby) {
  EXPECT_EQ(repeat_rows("honeycomb", {{"profile", "A B"}, {"unit_size", "1"}}),
            (Rows{"1010", "0101", "1011", "0111", "1010", "0101", "1110", "1101"}));
  const WeaveKind& kind = *find_weave("honeycomb");
  const Design d = new_draft(kind, {{"unit_size", "1"}}, {4, 4}).design;
  EXPECT_EQ(d.draft.weft.yarn, (std::vector<int>{1, 1, 0, 0})) << "the outline is the thick yarn";
}

TEST(WeaveKinds, TiedWeaves) {
  EXPECT_EQ(repeat_rows("summer_winter", {{"kind", "in pairs"}, {"profile", "A"}}),
            (Rows{"1000", "1010", "0010", "0101", "0010", "1010", "1000", "0101"}));
  EXPECT_EQ(repeat_rows("taquete", {{"profile", "A"}}), (Rows{"1000", "1101", "0010", "0111"}));
  EXPECT_EQ(repeat_rows("taquete", {{"profile", "A"}, {"kind", "twill"}}),
            (Rows{"100000", "110101", "001000", "011101", "000010", "010111"}));
  EXPECT_EQ(repeat_rows("beiderwand", {{"profile", "A B"}, {"unit_size", "1"}}),
            (Rows{"101010101010", "100000111011", "010101010101", "000100011111",  // block A
                  "101010101010", "111011100000", "010101010101", "011111000100"}));
}

TEST(WeaveKinds, TurnedBlockWeavesHaveTheOtherSystemOnTop) {
  const Rows taquete = repeat_rows("taquete", {{"profile", "A"}}),
             jin = repeat_rows("taquete", {{"profile", "A"}, {"turned", "yes"}});
  for (size_t p = 0; p < 4; ++p)
    for (size_t e = 0; e < 4; ++e) EXPECT_NE(taquete[p][e], jin[e][p]);
}

TEST(WeaveKinds, LayersAndTheirExchange) {
  EXPECT_EQ(repeat_rows("double_blocks", {{"profile", "A"}}), (Rows{"1000", "1110", "0010", "1011"}))
      << "each light pick over the dark ones, each dark pick below all light ends";
  EXPECT_EQ(repeat_rows("deflected", {{"profile", "A B"}, {"unit_size", "1"}}),
            (Rows{"10001011", "01000111", "11100010", "11010001", "10111000", "01110100", "00101110", "00011101"}));
  // Twill lifts 1 and 2 of the upper cloth; lower end 1, between them, rises over that pick.
  EXPECT_EQ(repeat_rows("stitched", {{"stitches", "1"}}).front(), "11100000");
}

TEST(WeaveKinds, CorkscrewTakesTheEndsOfATwillHalfARepeatApart) {
  EXPECT_EQ(repeat_rows("corkscrew", {{"shafts", "5"}}), (Rows{"11010", "10110", "10101", "01101", "01011"}));
}

TEST(WeaveKinds, JinBindsPairsBetweenPatternPicks) {
  // Line 1 2 3 2, the second warp two shafts above: ends 1 3 2 4 3 1 2 4.
  EXPECT_EQ(
      repeat_rows("jin",
                  {{"shafts", "4"}, {"line", "points"}, {"length", "4"}, {"height", "1"}, {"treadling", "straight"}}),
      (Rows{"10100110", "11001100", "01101010", "00110011", "01011001", "11001100", "10010101", "00110011"}));
}

TEST(WeaveKinds, EchoRaisesOneOfEachPair) {
  for (const std::string& row : repeat_rows("echo", {}))
    for (size_t e = 0; e < row.size(); e += 2) ASSERT_NE(row[e], row[e + 1]);
  const Design d = new_draft(*find_weave("echo"), {}, {4, 2}).design;
  EXPECT_EQ(d.draft.warp.color, (std::vector<int>{0, 1, 0, 1})) << "two warps of different colours";
}

TEST(Overshot, SixBlocksOnSixShafts) {
  const WeaveValues values = {{"profile", "A B C D E F"}, {"block", "4"}, {"picks", "1"}};
  const Rows rows = repeat_rows("overshot", values);
  ASSERT_EQ(rows.size(), 12u) << "a pattern pick and a tabby for each block";
  // Ends on shafts 1 2 1, 2 3 2, ... 6 1 6. Block A is covered, E (opposite) is above, the others are half tones.
  EXPECT_EQ(rows[0], "000010101010111101");
  EXPECT_EQ(rows[1], "101010101010101010");
  EXPECT_EQ(rows[3], "010101010101010101");
}

TEST(Overshot, FashionsAndTrompAsWrit) {
  const auto pattern_treadles = [](WeaveValues values) {
    values.insert(values.end(), {{"profile", "A B A C D"}, {"block", "4"}, {"picks", "1"}});
    const WeaveKind& kind = *find_weave("overshot");
    const Draft d = kind.make(complete_values(kind, values), {40, 40}).design.draft;
    std::vector<int> out;
    for (int p = 0; p < 40; p += 2) out.push_back(d.treadling.first(p));
    return out;
  };
  const std::vector<int> star = pattern_treadles({}), rose = pattern_treadles({{"fashion", "rose"}});
  EXPECT_EQ(std::vector<int>(star.begin(), star.begin() + 5), (std::vector<int>{0, 1, 0, 2, 3}));
  EXPECT_EQ(std::vector<int>(rose.begin(), rose.begin() + 5), (std::vector<int>{1, 0, 1, 3, 2}));
  // Tromp as writ: the pairs of ends within a block, and those across to the next, which are of block A on both sides
  // of B.
  const std::vector<int> writ = pattern_treadles({{"treadling", "tromp as writ"}});
  EXPECT_EQ(std::vector<int>(writ.begin(), writ.begin() + 8), (std::vector<int>{0, 0, 0, 1, 1, 0, 0, 0}));
}

TEST(Substitution, TheSatinTemplateIsASatinWithACleanCut) {
  const auto templates = block_templates();
  const auto satin =
      std::ranges::find_if(templates, [](const BlockTemplate& t) { return std::string(t.id) == "satin"; });
  const BitMatrix cells = drawdown(substituted(*satin, {{0, 1}}, {10, 10}).design.draft);
  for (int p = 0; p < 10; ++p) EXPECT_NE(cells.get(p, 4), cells.get(p, 5)) << p;
  for (int e = 0; e < 10; ++e) EXPECT_NE(cells.get(4, e), cells.get(5, e)) << e;
  for (int p = 0; p < 5; ++p)
    for (int e = 0; e < 5; ++e) {
      EXPECT_EQ(cells.get(p, e), (3 + 2 * p) % 5 == e) << "weft satin";
      EXPECT_EQ(cells.get(p, 5 + e), e != (1 + 3 * p) % 5) << "warp satin";
    }
}

TEST(Substitution, BracketsRepeatWithinAUnit) {
  const BlockTemplate unit{"own", 1, "2(1 a) n(1)", "3(1) a"};
  EXPECT_EQ(text_of(drawdown(substituted(unit, {{0}}, {7, 4}, 3).design.draft)),
            (Rows{"1010111", "1010111", "1010111", "0101000"}));
  const BlockTemplate vast{"own", 1, "9999(9999(9999(1 a)))", "n(n(n(1 a)))"};
  EXPECT_TRUE(is_consistent(substituted(vast, {{0}}, {7, 4}, 9999).design));
}

/// The cloth of double width laid open: ends of the upper layer, then those of the lower one from the fold back.
BitMatrix unfolded(const BitMatrix& cells) {
  const int n = cells.cols() / 2, picks = cells.rows() / 2;
  BitMatrix open(picks, 2 * n);
  for (int p = 0; p < picks; ++p) {
    // Upper, lower, lower, upper.
    const int upper = 2 * p + (p % 2 == 1), lower = 2 * p + (p % 2 == 0);
    for (int e = 0; e < n; ++e) {
      open.set(p, e, cells.get(upper, 2 * e));
      open.set(p, 2 * n - 1 - e, !cells.get(lower, 2 * e + 1));
    }
  }
  return open;
}

TEST(DoubleCloth, OfDoubleWidthUnfoldsToOneTwill) {
  for (const OverUnder& order : {OverUnder{1, 1}, OverUnder{2, 2}, OverUnder{3, 1}, OverUnder{3, 1, 1, 3}}) {
    const int n = std::accumulate(order.begin(), order.end(), 0);
    const BitMatrix cells = drawdown(double_cloth(DoubleCloth::kDoubleWidth, order, {8 * n, 8 * n}).draft);
    EXPECT_EQ(unfolded(cells), drawdown(twill(order, Lean::kRight, {8 * n, 4 * n}).draft)) << n;
  }
}

// ---- codes of ISO 9354

TEST(IsoCode, KnownCodes) {
  const auto rows = [](const char* code) { return text_of(*read_iso_code(code)); };
  EXPECT_EQ(rows("10-01 01-01-00"), (Rows{"10", "01"}));
  EXPECT_EQ(rows("11-01 01-01-00"), (Rows{"01", "10"}));
  EXPECT_EQ(rows("10-02 02-02-00"), (Rows{"1100", "1100", "0011", "0011"})) << "basket";
  EXPECT_EQ(rows("10-03 03-01-00"), (Rows{"10", "10", "10", "01", "01", "01"})) << "rib of three picks";
  EXPECT_EQ(rows("10-01 01-02 01-00"), (Rows{"110", "001"})) << "groups of two ends and of one";
  EXPECT_EQ(rows("20-02 02-01-01"), (Rows{"1001", "1100", "0110", "0011"}));
  EXPECT_EQ(rows("20-0202-01-01"), rows("20-02 02-01-01")) << "written without blanks";
  EXPECT_EQ(rows("21-01 03-01-01"), (Rows{"0111", "1011", "1101", "1110"}));
  EXPECT_EQ(rows("30-04 01-01-02"), (Rows{"11101", "10111", "11110", "11011", "01111"})) << "a warp satin";
  EXPECT_EQ(rows("30-05 01-01-03 04 04 03 02").size(), 6u);
}

std::string code_of(const BitMatrix& repeat) { return iso_code(repeat, {repeat.cols(), repeat.rows()}); }

TEST(IsoCode, OfDrafts) {
  const auto code = [](const Design& d) { return code_of(drawdown(d.draft)); };
  EXPECT_EQ(code(plain({2, 2})), "10-01 01-01-00");
  EXPECT_EQ(code(basket(3, {6, 6})), "10-03 03-03-00");
  EXPECT_EQ(code(twill({2, 2}, Lean::kRight, {4, 4})), "20-02 02-01-01");
  EXPECT_EQ(code(twill({2, 2}, Lean::kLeft, {4, 4})), "20-02 02-01-03");
  EXPECT_EQ(code(twill({1, 3}, Lean::kRight, {4, 4})), "20-01 03-01-01");
  EXPECT_EQ(code(satin(8, 3, Face::kFront, {8, 8})), "30-07 01-01-03");
  EXPECT_EQ(code(satin(5, 2, Face::kBack, {5, 5})), "30-01 04-01-03");
  EXPECT_EQ(code(waffle(4, {6, 6})), "") << "the standard codes no such weave";
  EXPECT_EQ(code_of(BitMatrix(0, 0)), "");
}

TEST(IsoCode, OfWhatACodeMadeIsItself) {
  for (const char* code : {"10-01 01-01-00", "10-02 02-02-00", "10-03 01-02 01-00", "20-03 01-01-01", "20-03 01-02-01",
                           "20-03 02 01 02-01-02", "20-04 03-01-06", "30-04 01-01-02", "30-05 01-01-03 04 04 03 02"}) {
    const base::Result<BitMatrix> read = read_iso_code(code);
    ASSERT_TRUE(read) << problem_of(read);
    const base::Result<BitMatrix> again = read_iso_code(code_of(*read));
    ASSERT_TRUE(again) << code;
    EXPECT_EQ(again->rows(), read->rows()) << code;
    EXPECT_EQ(code_of(*again), code_of(*read)) << code;
  }
}

TEST(IsoCode, SaysWhatIsWrong) {
  for (const char* code : {"", "20", "20-02 02-01", "20-02 02-01-01-01", "40-02 02-01-01", "22-02 02-01-01",
                           "20-02-01-01", "20-02 00-01-01", "20-02 02-00-01", "20-02 02-01 01-01", "20-02 02-01-00",
                           "20-02 02-01-01 02", "10-01 01-01-01", "20-02 x2-01-01", "-----", "20-99 99-99-01"}) {
    const base::Result<BitMatrix> read = read_iso_code(code);
    ASSERT_FALSE(read) << code;
    EXPECT_NE(problem_of(read).find("is not an ISO 9354 weave code"), std::string::npos);
  }
  EXPECT_FALSE(check_values(*find_weave("iso"), {{"code", "20-02"}})) << "mended in silence";
}

// ---- every row over its parameters

int number(const WeaveValues& v, const char* id) { return count(v, id); }
OverUnder order_of(const WeaveValues& v) { return read_ratio(text(v, "ratio")); }
int longest_of(const OverUnder& order) { return *std::ranges::max_element(order); }
int shafts_of(const OverUnder& order) { return std::accumulate(order.begin(), order.end(), 0); }

/// Letters of a profile in a row, round its repeat, that are (`inside`) or are not one letter: the most there are.
int letters(const WeaveValues& v, bool inside) {
  std::vector<int> blocks = read_profile(text(v, "profile")).value;
  if (std::ranges::all_of(blocks, [](int b) { return b == 0; })) blocks.push_back(1);  // as the weaves add it
  const int n = static_cast<int>(blocks.size());
  int most = 0;
  for (const int letter : blocks)
    for (int first = 0; first < n; ++first) {
      int run = 0;
      while (run < n && (blocks[static_cast<size_t>((first + run) % n)] == letter) == inside) ++run;
      most = std::max(most, run);
    }
  return most;
}

/// What a row promises of its cloth; nothing where a weaver may write what falls apart.
struct Promise {
  std::function<int(const WeaveValues&)> longest_float = {};
  std::function<int(const WeaveValues&)> layers = [](const WeaveValues&) { return 1; };
};

const std::map<std::string, Promise>& promises() {
  using V = const WeaveValues&;
  const auto at_most = [](int n) { return Promise{[n](V) { return n; }}; };
  const auto times_ratio = [](int n) { return Promise{[n](V v) { return n * longest_of(order_of(v)); }}; };
  const auto pairs = [](int more) { return Promise{[more](V v) { return 2 * number(v, "unit_size") + more; }}; };
  const Promise spot{[](V v) { return 2 * number(v, "unit_size") * letters(v, true) + 1; }};
  const Promise in_layers{[](V v) {
                            const int layers = is(v, "kind", "tube") ? 2 : number(v, "layers");
                            return layers * longest_of(order_of(v)) * (is(v, "kind", "double width") ? 3 : 2);
                          },
                          [](V v) { return is(v, "kind", "tube") ? 2 : number(v, "layers"); }};
  static const std::map<std::string, Promise> kAll = {
      {"plain", at_most(1)},
      {"straight", {}},
      {"basket", {[](V v) { return number(v, "group"); }}},
      {"twill", times_ratio(1)},
      {"broken_twill", {}},
      {"point_twill", times_ratio(2)},
      {"herringbone", {}},
      {"corkscrew", {[](V v) { return number(v, "shafts") / 2 + 1; }}},
      {"advancing_twill", {}},
      {"undulating_twill", {[](V v) { return longest_of(order_of(v)) * std::max(2, number(v, "widest")); }}},
      {"network", {}},
      {"satin", {[](V v) { return number(v, "shafts") - 1; }}},
      {"waffle", {[](V v) { return 2 * number(v, "shafts") - 3; }}},
      {"honeycomb", {[](V v) {
         return 2 * number(v, "unit_size") * std::max(letters(v, true), letters(v, false)) + 2 * letters(v, false) + 1;
       }}},
      {"huck", pairs(3)},
      {"bronson", {[](V v) { return 2 * number(v, "unit_size") * letters(v, true) + 1; }}},
      {"bronson_lace", pairs(1)},
      {"canvas", pairs(3)},
      {"ms_and_os", pairs(0)},
      {"swivel", spot},
      {"clipped_spots",
       {[](V v) { return std::max(3, 2 * number(v, "unit_size") * std::max(letters(v, true), letters(v, false))); }}},
      {"overshot", {[](V v) { return std::max(3, number(v, "block") * letters(v, true) + 4); }}},
      {"crackle", {}},
      {"damask", at_most(3)},
      {"substitution", {}},
      {"summer_winter", at_most(3)},
      {"taquete", at_most(5)},
      {"beiderwand", {[](V v) { return 4 * number(v, "unit_size") + 1; }}},
      {"echo", {}},
      {"jin", at_most(3)},
      {"double", in_layers},
      {"double_blocks",
       {[](V) { return 3; },
        [](V v) {
          return std::ranges::count(read_profile(text(v, "profile")).value, 0) ==
                         static_cast<int>(read_profile(text(v, "profile")).value.size())
                     ? 2
                     : 1;
        }}},
      {"stitched", {[](V v) { return 3 * longest_of(order_of(v)) + 1; }}},
      {"deflected", pairs(1)},
      {"sections", {}},
      {"iso", {}},
      {"shadow", {}},
      {"log_cabin", at_most(1)},
      {"houndstooth", times_ratio(1)},
      {"glen_check", times_ratio(1)},
      {"sett", times_ratio(1)},
  };
  return kAll;
}

/// Values from the whole range of each parameter; round 0: the defaults, 1: the lowest, 2: the highest.
WeaveValues values_of(const WeaveKind& kind, int round, std::mt19937& random) {
  constexpr const char* kProfiles[] = {"A B", "A2 B2", "A B C B", "A", "A3 B C2", "A B C D E F", "A E A C"};
  constexpr const char* kRatios[] = {"2/2", "3/1", "4/4", "1/3/2/2", "3/2/1/2", "1/1", "5/1/1/1"};
  constexpr const char* kCodes[] = {"10-03 03-02-00", "20-03 02 01 02-01-02", "31-01 06-01-03", "30-04 01-01-03"};
  WeaveValues values;
  for (const WeaveParameter& n : kind.parameters) {
    std::string value = n.default_value;
    const std::string_view id = n.id;
    if (round > 0 && n.kind == ParameterKind::kCount) {
      const auto range = static_cast<unsigned>(n.high - n.low + 1);
      value = std::to_string(round == 1 ? n.low : round == 2 ? n.high : n.low + static_cast<int>(random() % range));
    }
    if (round > 0 && n.kind == ParameterKind::kChoice) value = n.choices[random() % n.choices.size()];
    if (round > 0 && id == "profile") value = kProfiles[random() % std::size(kProfiles)];
    if (round > 0 && id == "ratio") value = kRatios[random() % std::size(kRatios)];
    if (round > 0 && id == "code") value = kCodes[random() % std::size(kCodes)];
    values.emplace_back(id, value);
  }
  return allowed_values(kind, values);
}

std::string said(const WeaveKind& kind, const WeaveValues& values) {
  std::string out = kind.id;
  for (const auto& [id, value] : values) out.append("; ").append(id).append("=").append(value);
  return out;
}

/// Each end on one shaft, each pick by one treadle, as many shafts as the parameters say.
void check_draft(const WeaveKind& kind, const WeaveValues& values, const Draft& d) {
  for (int e = 0; e < d.ends(); ++e) ASSERT_EQ(d.threading.count(e), 1) << "end " << e;
  for (int p = 0; p < d.picks(); ++p) ASSERT_EQ(d.treadling.count(p), 1) << "pick " << p;
  const bool layered = std::string_view(kind.family) == "Layers";
  for (const WeaveParameter& n : kind.parameters) {
    const std::string_view id = n.id;
    if (id == "shafts") {
      EXPECT_EQ(d.shafts, number(values, "shafts"));
    } else if (id == "ratio" && !layered) {
      EXPECT_EQ(d.shafts, shafts_of(order_of(values)));
    }
  }
}

void check_cloth(const Promise& promise, const WeaveValues& values, const BitMatrix& cells) {
  if (!promise.longest_float) return;
  const analysis::LongestFloats f = longest_floats(cells);
  EXPECT_LE(std::max({f.warp_front, f.warp_back, f.weft_front, f.weft_back}), promise.longest_float(values));
  const std::vector<WeaveLayer> layers = weave_layers(cells);
  EXPECT_EQ(static_cast<int>(layers.size()), promise.layers(values));
  for (const WeaveLayer& layer : layers) EXPECT_FALSE(layer.loose());
}

TEST(WeaveKinds, AreSoundClothOverTheRangesOfTheirParameters) {
  constexpr int kRounds = 8;
  std::mt19937 random(9354);
  for (const WeaveKind& kind : weave_kinds()) {
    ASSERT_TRUE(promises().contains(kind.id)) << kind.id << " promises nothing";
    for (int round = 0; round < kRounds; ++round) {
      const WeaveValues values = values_of(kind, round, random);
      SCOPED_TRACE(said(kind, values));
      const ClothSize repeat = repeat_of(kind, values);
      const bool whole = repeat.ends > 0 && repeat.picks > 0;  // otherwise it has more than 1,024 threads
      const GeneratedWeave made = new_draft(kind, values, whole ? repeat : ClothSize{200, 200});
      ASSERT_TRUE(is_consistent(made.design));
      check_draft(kind, values, made.design.draft);
      if (round == 0) {
        EXPECT_EQ(made.note, "");
        EXPECT_TRUE(whole);
      }
      if (whole) check_cloth(promises().at(kind.id), values, drawdown(made.design.draft));
      if (HasFatalFailure()) return;
    }
  }
}

TEST(WeaveKinds, SayWhatTheyAreAndWhatTheyAreFor) {
  for (const WeaveKind& kind : weave_kinds()) {
    const std::string_view text = kind.description;
    EXPECT_EQ(text.back(), '.') << kind.id;
    EXPECT_NE(text.find_first_of(".;:"), text.size() - 1) << kind.id << " says one thing only";
    EXPECT_LE(text.size(), 240u) << kind.id;
  }
}

}  // namespace
}  // namespace weftlight::weaves
