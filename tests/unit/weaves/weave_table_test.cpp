// The table of weaves, and the families beyond the simple ones.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <set>

#include "../hand_drafts.h"
#include "analysis/floats.h"
#include "design/edits.h"
#include "design/repeat.h"
#include "draft/factor.h"
#include "weaves/families.h"
#include "weaves/table.h"

namespace weftlight::weaves {

using design::Design, design::Repeat, design::Rows, design::WeaveUse, design::design_repeat, design::is_consistent,
    design::text_of, design::to_liftplan, design::with_rising, design::with_size;
using draft::BitMatrix, draft::Rgb, draft::ShedControl, draft::drawdown, draft::transposed;

namespace {

Rows woven(const Design& d) { return text_of(drawdown(d.draft)); }

WeaveUse use_of(const char* weave, WeaveValues values, int e0, int ends, int p0, int picks) {
  return {weave, std::move(values), e0, ends, p0, picks};
}

// Longest run of equal cells down any column, cyclic.
int longest_run_down(const BitMatrix& m, bool of) {
  int longest = 0;
  for (int c = 0; c < m.cols(); ++c)
    for (int start = 0; start < m.rows(); ++start) {
      int run = 0;
      while (run < m.rows() && m.get((start + run) % m.rows(), c) == of) ++run;
      longest = std::max(longest, run);
    }
  return longest;
}

TEST(WeaveTable, EveryWeaveMakesADraftWithDefaultAndExtremeParameters) {
  std::set<std::string> ids;
  for (const WeaveKind& kind : weave_kinds()) {
    EXPECT_TRUE(ids.insert(kind.id).second) << kind.id;
    for (const int end : {0, 1, 2}) {
      WeaveValues values;
      for (const WeaveParameter& n : kind.parameters)
        if (n.kind == ParameterKind::kCount && end > 0)
          values.emplace_back(n.id, std::to_string(end == 1 ? n.low : n.high));
      const GeneratedWeave made = kind.make(complete_values(kind, values), {24, 20});
      EXPECT_TRUE(is_consistent(made.design)) << kind.id;
      EXPECT_EQ(made.design.draft.ends(), 24);
      EXPECT_EQ(made.design.draft.picks(), 20);
      if (end == 0) {
        EXPECT_EQ(made.note, "") << kind.id;
      }
      EXPECT_GT(drawdown(made.design.draft).count(), 0) << kind.id;
    }
  }
}

TEST(WeaveTable, NamesOfChoicesAreThoseOfEachChoice) {
  for (const WeaveKind& kind : weave_kinds())
    for (const WeaveParameter& n : kind.parameters)
      if (!n.names.empty()) {
        EXPECT_EQ(n.names.size(), n.choices.size()) << kind.id << " " << n.id;
      }
}

TEST(WeaveTable, InvalidTextMakesADraftAndIsReported) {
  std::mt19937 random(5);
  for (const WeaveKind& kind : weave_kinds())
    for (int round = 0; round < 8; ++round) {
      WeaveValues values;
      for (const WeaveParameter& n : kind.parameters) {
        std::string text;
        for (int i = 0; i < 12; ++i) text += "0123456789/ABz-x(), |a#"[random() % 23];
        values.emplace_back(n.id, text);
      }
      ASSERT_TRUE(is_consistent(kind.make(complete_values(kind, values), {9, 7}).design)) << kind.id;
    }
}

TEST(WeaveTable, RepeatOfAWeave) {
  const ClothSize twill = repeat_of(*find_weave("twill"), {{"ratio", "3/1/1/3"}});
  EXPECT_EQ(twill.ends, 8);
  EXPECT_EQ(twill.picks, 8);
  const ClothSize check = repeat_of(*find_weave("sett"), {{"sett", "R8 K4"}, {"ratio", "2/2"}});
  EXPECT_EQ(check.ends, 12);
  EXPECT_EQ(repeat_of(*find_weave("herringbone"), {{"band", "10"}}).ends, 20);
}

TEST(WeaveTable, WholeRepeatsFitEveryWeave) {
  for (const WeaveKind& kind : weave_kinds()) {
    const WeaveValues values = allowed_values(kind, {});
    const ClothSize repeat = repeat_of(kind, values);
    EXPECT_GT(repeat.ends, 0) << kind.id;
    EXPECT_GT(repeat.picks, 0) << kind.id;
    const ClothSize size = whole_repeats(repeat, {48, 48});
    const Design design = new_draft(kind, values, size).design;
    const Repeat found = design_repeat(design, drawdown(design.draft));
    EXPECT_EQ(size.ends % found.ends, 0) << kind.id;
    EXPECT_EQ(size.picks % found.picks, 0) << kind.id;
    EXPECT_LE(found.ends, repeat.ends) << kind.id << " does not repeat at its edge";
    EXPECT_LE(found.picks, repeat.picks) << kind.id << " does not repeat at its edge";
  }
}

TEST(WeaveTable, SizesAreWholeRepeatsNearTheRequest) {
  EXPECT_EQ(whole_repeats({14, 8}, {48, 48}).ends, 42);
  EXPECT_EQ(whole_repeats({14, 8}, {50, 3}).ends, 56);
  EXPECT_EQ(whole_repeats({14, 8}, {50, 3}).picks, 8);
  EXPECT_EQ(whole_repeats({0, 0}, {50, 3}).ends, 50);
}

TEST(WeaveTable, ANewDraftKeepsItsParametersUntilAnotherWeaveCoversIt) {
  const GeneratedWeave made = new_draft(*find_weave("herringbone"), {{"band", "12"}}, {48, 24});
  EXPECT_EQ(made.note, "");
  EXPECT_NE(made.design.draft.warp.color[0], made.design.draft.weft.color[0]);
  ASSERT_EQ(made.design.weaves.size(), 1u);
  EXPECT_EQ(made.design.weaves[0].values, (WeaveValues{{"band", "12"}, {"ratio", "2/2"}}));
  EXPECT_EQ(with_weave(made.design, made.design.weaves[0])->design, made.design);
}

TEST(WeaveTable, ARatioThatCannotBeReadIsRefused) {
  const WeaveKind& twill = *find_weave("twill");
  EXPECT_TRUE(check_values(twill, {{"ratio", "3/1"}}));
  EXPECT_NE(problem_of(check_values(twill, {{"ratio", "3/x"}})).find("'3/x' is not a ratio"), std::string::npos);
  EXPECT_TRUE(check_values(*find_weave("plain"), {}));
  const Design before = new_draft(twill, {}, {8, 8}).design;
  EXPECT_FALSE(with_weave(before, {"twill", {{"ratio", "3/x"}}, 0, 8, 0, 8})) << "mended in silence";
}

TEST(Satin, ChangingTheShaftsChangesTheStep) {
  const WeaveKind& satin = *find_weave("satin");
  const auto brought = [&](const char* shafts, const char* step) {
    const WeaveValues v = allowed_values(satin, {{"shafts", shafts}, {"step", step}});
    return v[1].second + " by " + v[2].second;
  };
  EXPECT_EQ(brought("8", "4"), "8 by 3") << "4 would return to the first end after two picks";
  EXPECT_EQ(brought("5", "5"), "5 by 3");
  EXPECT_EQ(brought("6", "3"), "5 by 3");
  EXPECT_EQ(brought("100", "7"), "64 by 7");
}

TEST(Satin, HasOnlyValidSteps) {
  EXPECT_EQ(satin_steps(5), (std::vector<int>{2, 3}));
  EXPECT_EQ(satin_steps(8), (std::vector<int>{3, 5}));
  EXPECT_TRUE(satin_steps(6).empty());
  const GeneratedWeave made = find_weave("satin")->make({{"shafts", "8"}, {"step", "4"}, {"face", "warp"}}, {8, 8});
  EXPECT_EQ(made.note, "a satin on 8 shafts has the steps 3 5; 3 is used");
}

TEST(Text, RatiosProfilesAndSequences) {
  EXPECT_EQ(read_ratio("2/2"), (OverUnder{2, 2}));
  EXPECT_EQ(read_ratio("3 1-1,3"), (OverUnder{3, 1, 1, 3}));
  EXPECT_EQ(read_ratio("4"), (OverUnder{4, 4}));
  for (const char* refused : {"x", "3/x", "3/1/1", "2/0", "0", "4000/4000"}) EXPECT_TRUE(read_ratio(refused).empty());
  EXPECT_EQ(read_profile("A2 b CA").value, (std::vector<int>{0, 0, 1, 2, 0}));
  EXPECT_EQ(read_profile("3x(A B) C").value, (std::vector<int>{0, 1, 0, 1, 0, 1, 2}));
  EXPECT_EQ(read_profile("A 2x, (B C) 3x").value, (std::vector<int>{0, 0, 1, 2, 1, 2, 1, 2}));
  EXPECT_EQ(read_profile("A 2(B A2 (C)*2)*2 X").value,
            (std::vector<int>{0, 1, 0, 0, 2, 2, 1, 0, 0, 2, 2, 1, 0, 0, 2, 2, 1, 0, 0, 2, 2, 23}));
  EXPECT_EQ(read_profile("A2(B)").value, (std::vector<int>{0, 0, 1}));
  EXPECT_EQ(read_profile("A B-C").note, "'-' is not read");
  EXPECT_EQ(read_profile("A 3 (B").note, "a bracket is not closed");
  EXPECT_EQ(read_profile("A2 B 3x(A B) C").note, "");
  EXPECT_EQ(read_profile("9999999(A 99999999)").value.size(), size_t{draft::kMaxThreads});
  EXPECT_EQ(read_sequence("1-3 2x(5 4) 3-1").value, (std::vector<int>{0, 1, 2, 4, 3, 4, 3, 2, 1, 0}));
  EXPECT_EQ(read_sequence("2(1 2(3))").value, (std::vector<int>{0, 2, 2, 0, 2, 2}));
  EXPECT_EQ(read_sequence("3x1 2 2 x 1-3").value, (std::vector<int>{0, 0, 0, 1, 0, 1, 2, 0, 1, 2}));
  EXPECT_EQ(read_sequence("2*(1 2*2)").value, (std::vector<int>{0, 1, 1, 0, 1, 1}));
  EXPECT_EQ(read_sequence("1 4x").note, "neither a number nor a bracket at character 3");
  EXPECT_EQ(read_sequence("4x9", 8).note, "a number outside 1 to 8 at character 4");
  EXPECT_FALSE(read_sequence("99999x1 99999x1").note.empty()) << "too many threads";
  EXPECT_EQ(read_sequence("1 9", 8).note, "a number outside 1 to 8 at character 4");
  EXPECT_EQ(read_sequence("2(1").note, "a bracket is not closed");
  EXPECT_FALSE(read_sequence("1)").note.empty());
  EXPECT_FALSE(read_sequence("99999(99999(1 2 3))").note.empty()) << "too many threads";
}

TEST(Text, OneRepeatOfASequenceIsWritten) {
  EXPECT_EQ(sequence_text({}), "");
  EXPECT_EQ(sequence_text(std::vector{2, 2, 2}), "3");
  EXPECT_EQ(sequence_text(std::vector{0, 0, 0, 0, 1, 1}), "4x1 2x2");
  EXPECT_EQ(sequence_text(std::vector{0, 0, 1, 0, 0, 1, 0}), "2x1 2") << "the last repeat is cut";
  EXPECT_EQ(sequence_text(std::vector{0, 1, 0, 0, 1, 1}), "1 2 2x1 2x2");
  for (const char* text : {"1", "1 2", "4x1 2x2", "12x3 1 2 1", "2x1 2 2x1 3"})
    EXPECT_EQ(sequence_text(read_sequence(text).value), text);
}

TEST(Text, SettsOfTartans) {
  const Sett turning = read_sett("R/8 K4 G/24").value;
  ASSERT_EQ(turning.stripes.size(), 4u);
  EXPECT_EQ(turning.stripes[3].threads, 4);
  EXPECT_EQ(turning.palette.size(), 3u);
  EXPECT_EQ(read_sett("LB2 #ff0000 6 DG3").value.stripes.size(), 3u);
  EXPECT_FALSE(read_sett("Q7").note.empty());
  for (const char* full : {"...R8 K4 G24...", "\xE2\x80\xA6 R8 K4 G24 \xE2\x80\xA6", "R8 K4 G24...",
                           "\xE2\x80\xA6R/8 K4 G/24\xE2\x80\xA6"}) {
    const auto [sett, note] = read_sett(full);
    EXPECT_EQ(note, "") << full;
    EXPECT_EQ(sett.stripes.size(), 3u) << full << ": it repeats, and does not reverse";
  }
  EXPECT_FALSE(read_sett("R8 ... G24").note.empty());
}

TEST(Network, StaysOnTheNetworkAndFollowsTheLine) {
  const std::vector<int> initial = {0, 1, 2, 3};
  std::vector<int> line;
  for (int e = 0; e < 40; ++e) line.push_back(e / 3);
  const std::vector<int> draw = network_threading(initial, line, 8);
  ASSERT_EQ(draw.size(), line.size());
  for (size_t e = 0; e < draw.size(); ++e) {
    EXPECT_EQ(draw[e] % 4, initial[e % 4]) << "every end is on the network";
    const int above = (draw[e] - line[e] % 8 + 8) % 8;
    EXPECT_LT(above, 4) << "the first shaft at or above the line";
  }
  // A flat line gives the initial itself.
  EXPECT_EQ(network_threading(initial, {0, 0, 0, 0, 0}, 8), (std::vector<int>{0, 1, 2, 3, 0}));
}

TEST(Crackle, AdjacentEndsAlternateOddAndEven) {
  for (const char* profile : {"A2 B2 C2 D2 C2 B2", "A C B D", "ADCB"}) {
    const Design d = find_weave("crackle")->make({{"profile", profile}, {"picks", "2"}}, {400, 8}).design;
    for (int e = 1; e < 100; ++e)
      ASSERT_NE(d.draft.threading.first(e) % 2, d.draft.threading.first(e - 1) % 2) << profile << " end " << e;
  }
}

TEST(Substitution, SummerAndWinterEqualsItsOwnGenerator) {
  const auto& unit = block_templates()[0];
  const std::vector<int> blocks = {0, 1, 1, 0};
  const Design by_template = substituted(unit, {blocks}, {16, 16}).design;
  EXPECT_EQ(by_template.draft.shafts, 4);
  // Pattern picks leave the pattern shafts of a marked block down: weft floats of three.
  const Rows rows = woven(by_template);
  EXPECT_EQ(rows[0].substr(0, 4), "1000") << "block A is marked: only its tie-down end is up";
  EXPECT_EQ(rows[0].substr(4, 4), "1101") << "block B is not marked";
  EXPECT_EQ(rows[1].substr(0, 8), "10101010") << "tabby";
}

TEST(Substitution, UserTemplatesAndTheirErrors) {
  const BlockTemplate own{"own", 0, "a b", "a b"};
  EXPECT_EQ(woven(substituted(own, {{0}}, {4, 2}).design), (Rows{"1010", "0101"}));
  EXPECT_FALSE(substituted({"own", 0, "1 2", "a"}, {{0}}, {4, 2}).note.empty());
  EXPECT_FALSE(substituted({"own", 0, "", ""}, {{0}}, {4, 2}).note.empty());
}

TEST(DoubleCloth, EachLayerWeavesIndependently) {
  const Rows rows = woven(double_cloth(DoubleCloth::kLayers, {1, 1}, {4, 4}));
  EXPECT_EQ(rows, (Rows{"1000", "1011", "0010", "1110"}));
  const Rows wide = woven(double_cloth(DoubleCloth::kDoubleWidth, {1, 1}, {4, 4}));
  EXPECT_EQ(wide, (Rows{"1000", "1110", "1011", "0010"})) << "upper, lower, lower, upper";
}

TEST(Picture, ColoursAreReducedDarkToLight) {
  Pixels picture{4, 2, {}};
  for (int i = 0; i < 8; ++i) picture.rgb.push_back(i % 4 < 2 ? Rgb{0.1f, 0.1f, 0.12f} : Rgb{0.9f, 0.85f, 0.8f});
  const Reduced r = reduced_colors(picture, 2);
  ASSERT_EQ(r.palette.size(), 2u);
  EXPECT_LT(r.palette[0].r, r.palette[1].r);
  EXPECT_EQ(r.index, (std::vector<int>{0, 0, 1, 1, 0, 0, 1, 1}));
  EXPECT_EQ(reduced_colors(picture, 9).palette.size(), 2u) << "the picture has no more";
}

TEST(Picture, FloatsAreBoundedOnBothFaces) {
  std::mt19937 random(41);
  for (int round = 0; round < 40; ++round) {
    const int longest = 3 + static_cast<int>(random() % 6);
    BitMatrix cells(40 + static_cast<int>(random() % 30), 40 + static_cast<int>(random() % 30));
    // Large plain areas, the worst case.
    for (int r = 0; r < cells.rows(); ++r)
      for (int c = 0; c < cells.cols(); ++c) cells.set(r, c, (r / 13 + c / 17 + round) % 2 == 0);
    const BitMatrix bound = with_bounded_floats(cells, longest);
    for (const bool of : {true, false}) {
      ASSERT_LE(longest_run_down(bound, of), longest) << "warp, limit " << longest;
      ASSERT_LE(longest_run_down(transposed(bound), of), longest) << "weft, limit " << longest;
    }
  }
}

/// 0: grey from dark to light; 1: a disc on a ground; 2: noise; 3: smooth, with noise, as photographs; 4: fine lines;
/// 5: one colour.
Pixels drawn(int kind, int width, int height) {
  std::mt19937 random(7);
  Pixels out{width, height, {}};
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const float u = (static_cast<float>(x) + 0.5f) / static_cast<float>(width),
                  v = (static_cast<float>(y) + 0.5f) / static_cast<float>(height);
      const float noise = static_cast<float>(random() % 1000) / 1000, far = std::hypot(u - 0.5f, v - 0.5f);
      const float smooth = 0.5f + 0.25f * std::sin(9 * u + 5 * v) + 0.15f * std::sin(31 * v) + 0.1f * noise;
      const float disc = far < 0.4f ? 0.5f + 0.5f * std::cos(8 * far) : 0.1f;
      const bool lines = x % 9 == 0 || y % 13 == 0 || std::abs(u - v) < 0.01f;
      const float of[] = {u, disc, noise, smooth, lines ? 0.1f : 0.9f, 0.4f};
      const float c = of[kind];
      out.rgb.push_back({c, c * c, 1 - 0.5f * c});
    }
  return out;
}

TEST(Picture, AnyPictureKeepsTheLimitOfFloats) {
  constexpr int kSizes[][2] = {{40, 40}, {97, 61}, {13, 17}, {8, 8}, {5, 90}, {150, 110}};
  for (int kind = 0; kind < 6; ++kind)
    for (const auto& [width, height] : kSizes)
      for (const int colors : {2, 3, 8, 16})
        for (const int shafts : {4, 5, 8, 16})
          for (const int longest : {2, 3, 4, 5, 7, 10}) {
            const BitMatrix cells = picture_weave(drawn(kind, width, height), {colors, longest, shafts});
            const analysis::LongestFloats f = analysis::longest_floats(cells);
            ASSERT_LE(std::max({f.warp_front, f.warp_back, f.weft_front, f.weft_back}), longest)
                << "kind " << kind << ", " << width << " x " << height << ", " << colors << " colours, " << shafts
                << " shafts";
          }
}

TEST(Picture, DarkIsWarpFacedAndFloatsOfOneArePlainWeave) {
  const BitMatrix shaded = picture_weave(drawn(0, 80, 80), {5, 7, 8});
  const auto warp_up = [&](int from, int to) {
    int up = 0;
    for (int pick = 0; pick < 80; ++pick)
      for (int end = from; end < to; ++end) up += shaded.get(pick, end);
    return up / (80.0 * (to - from));
  };
  for (int from = 0; from < 64; from += 16) EXPECT_GT(warp_up(from, from + 16), warp_up(from + 16, from + 32)) << from;
  const BitMatrix plain = picture_weave(drawn(3, 20, 12), {5, 1, 8});
  for (int pick = 0; pick < 12; ++pick)
    for (int end = 0; end < 20; ++end) ASSERT_EQ(plain.get(pick, end), (pick + end) % 2 == 0);
}

TEST(Picture, BecomesAJacquardDraft) {
  Pixels picture{30, 20, std::vector<Rgb>(600, Rgb{0.5f, 0.5f, 0.5f})};
  for (int i = 0; i < 200; ++i) picture.rgb[static_cast<size_t>(i)] = {0, 0, 0};
  const BitMatrix cells = picture_weave(picture, {3, 7, 8});
  const std::optional<Design> design = jacquard_design(cells);
  ASSERT_TRUE(design);
  EXPECT_TRUE(is_consistent(*design));
  EXPECT_EQ(drawdown(design->draft), cells);
}

TEST(ApplyWeave, OverAllThreadsReplacesTheDraftAndKeepsItsParameters) {
  Design d = with_size(Design{}, 24, 24, 2, 2);
  d.title = "Mine";
  const GeneratedWeave made = with_weave(d, use_of("twill", {{"ratio", "2/2"}}, 0, 24, 0, 24)).value();
  EXPECT_EQ(made.note, "");
  EXPECT_EQ(made.design.title, "Mine");
  EXPECT_EQ(made.design.draft.shafts, 4);
  ASSERT_EQ(made.design.weaves.size(), 1u);
  WeaveUse again = made.design.weaves[0];
  for (auto& [id, value] : again.values)
    if (id == "ratio") value = "3/1/1/3";
  const GeneratedWeave changed = with_weave(made.design, again).value();
  EXPECT_EQ(changed.design.draft.shafts, 8);
  EXPECT_EQ(changed.design.weaves.size(), 1u);
  EXPECT_EQ(changed.design.draft.warp.color, d.draft.warp.color);
}

TEST(ApplyWeave, OverSomeThreadsKeepsTheRest) {
  const Design d = with_weave(with_size(Design{}, 24, 24, 2, 2), use_of("plain", {}, 0, 24, 0, 24))->design;
  const GeneratedWeave made = with_weave(d, use_of("twill", {{"ratio", "2/2"}}, 8, 8, 4, 8)).value();
  EXPECT_EQ(made.note, "");
  BitMatrix expected = drawdown(d.draft);
  const BitMatrix part = drawdown(twill({2, 2}, Lean::kRight, {8, 8}).draft);
  for (int p = 0; p < 8; ++p)
    for (int e = 0; e < 8; ++e) expected.set(4 + p, 8 + e, part.get(p, e));
  EXPECT_EQ(drawdown(made.design.draft), expected);
  EXPECT_EQ(made.design.draft.threading.first(0), 0);
  EXPECT_EQ(made.design.draft.threading.first(1), 1);
}

TEST(ApplyWeave, SaysWhyNot) {
  const Design d = with_size(Design{}, 24, 24, 2, 2);
  EXPECT_FALSE(with_weave(d, use_of("nonsense", {}, 0, 24, 0, 24)));
  EXPECT_FALSE(with_weave(d, use_of("plain", {}, 30, 4, 0, 24)));
}

TEST(ApplyWeave, StaysWithinTheLoom) {
  Design d = with_size(Design{}, 24, 24, 4, 4);
  const WeaveUse satin = use_of("satin", {}, 0, 24, 0, 24);
  ASSERT_EQ(with_weave(d, satin)->design.draft.shafts, 8) << "a loom that is not known has all";
  d.loom.shafts = 4;
  EXPECT_EQ(problem_of(with_weave(d, satin)), "this needs 8 shafts, but the loom has 4");
  d.loom = {}, d.loom.treadles = 4;
  EXPECT_EQ(problem_of(with_weave(d, satin)), "this needs 8 treadles, but the loom has 4");
  EXPECT_TRUE(with_weave(to_liftplan(d), satin)) << "a liftplan has no treadles";
  EXPECT_TRUE(with_weave(d, use_of("twill", {{"ratio", "2/2"}}, 0, 24, 0, 24)));
  d = with_size(d, 24, 24, 8, 8);
  EXPECT_TRUE(with_weave(d, satin)) << "the draft has as many";
}

TEST(ApplyWeave, OnASinkingShedAndByLiftplan) {
  Design d = with_rising(with_size(Design{}, 12, 12, 2, 2), false);
  const BitMatrix wanted = drawdown(twill({3, 1}, Lean::kRight, {12, 12}).draft);
  EXPECT_EQ(drawdown(with_weave(d, use_of("twill", {{"ratio", "3/1"}}, 0, 12, 0, 12))->design.draft), wanted);
  d = to_liftplan(d);
  const Design plan = with_weave(d, use_of("twill", {{"ratio", "3/1"}}, 0, 12, 0, 12))->design;
  EXPECT_EQ(drawdown(plan.draft), wanted);
  EXPECT_EQ(plan.draft.shed_control, ShedControl::kLiftplan);
}

// Found by the fuzzer: two layers of 3,290 shafts each exceed the limit.
TEST(WeaveTable, RatiosOfManyShaftsMakeConsistentDraftsAndAreReported) {
  for (const WeaveKind& kind : weave_kinds()) {
    if (std::ranges::none_of(kind.parameters,
                             [](const WeaveParameter& n) { return std::string_view(n.id) == "ratio"; }))
      continue;
    for (const char* ratio : {"4096", "2049", "2048/2048", "3288/2", "99999/1"}) {
      const GeneratedWeave made = new_draft(kind, {{"ratio", ratio}}, {24, 24});
      EXPECT_TRUE(is_consistent(made.design)) << kind.id << ' ' << ratio;
    }
  }
  EXPECT_NE(new_draft(*find_weave("double"), {{"ratio", "3288/2"}}, {24, 24}).note, "");
  EXPECT_NE(new_draft(*find_weave("twill"), {{"ratio", "4096"}}, {24, 24}).note, "");
}

}  // namespace
}  // namespace weftlight::weaves
