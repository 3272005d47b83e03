// Orders of sections as text, as a list and as threads.

#include "weaves/sections.h"

#include <gtest/gtest.h>

#include "design/edits.h"

namespace weftlight::weaves {

using design::Assembly, design::Design, design::is_consistent;
using draft::BitMatrix, draft::ShedControl, draft::System, draft::blank_draft;

namespace {

std::string again(std::string_view text) {
  const auto order = read_order(text);
  EXPECT_TRUE(order) << problem_of(order);
  return order_text(order.value_or(std::vector<OrderItem>{}));
}

TEST(Sections, OrdersAreReadInTheirNotations) {
  EXPECT_EQ(again("A 4x, (B C) 3x, A"), "A 4x, (B C) 3x, A");
  EXPECT_EQ(again("4x A 3x(B C) A"), "A 4x, (B C) 3x, A");
  EXPECT_EQ(again("A x4 ( B,C )3 A"), "A 4x, (B C) 3x, A");
  EXPECT_EQ(again("A, 4x B"), "A B 4x") << "after a comma a count belongs to the next item";
  EXPECT_EQ(again("A 4x B"), "A 4x, B") << "otherwise to the item before it";
  EXPECT_EQ(again("((A 2x) 2x)"), "((A 2x) 2x)");
  EXPECT_EQ(again("Rand_1 \xC3\x84"), "Rand_1 \xC3\x84");
  EXPECT_EQ(again(""), "");
  EXPECT_EQ(again("()"), "()");
}

TEST(Sections, TurnsStandRightAfterTheirItem) {
  EXPECT_EQ(again("A' 4x, (B C<>)' 3x, A<>"), "A' 4x, (B C<>)' 3x, A<>");
  EXPECT_EQ(read_order("(A B)<> 2x").value()[0].turn, Turn::kForthAndBack);
  EXPECT_EQ(problem_of(read_order("A '")), "a turn without a section at character 3");
  EXPECT_EQ(section_name("A'<>"), "A");
}

TEST(Sections, ErrorsNameTheirPosition) {
  EXPECT_EQ(problem_of(read_order("A (B")), "a bracket is not closed at character 3");
  EXPECT_EQ(problem_of(read_order("A ) B")), "an unmatched closing bracket at character 3");
  EXPECT_EQ(problem_of(read_order("A, 3x")), "a repeat count without a section at character 4");
  EXPECT_EQ(problem_of(read_order("3x 4x A")), "two repeat counts in a row at character 4");
  EXPECT_EQ(problem_of(read_order("A 0x")), "a repeat count below 1 at character 3");
  EXPECT_EQ(problem_of(read_order("0x A")), "a repeat count below 1 at character 1");
  EXPECT_FALSE(read_order(std::string(1000, '(')));
  std::string many;
  for (int i = 0; i < 20000; ++i) many += "A ";
  EXPECT_FALSE(read_order(many));
}

TEST(Sections, TheListHasOneRowPerItem) {
  std::vector<OrderItem> items = read_order("A 4x (B C 2x) 3x D").value();
  const std::vector<OrderRow> rows = order_rows(items);
  ASSERT_EQ(rows.size(), 5u);
  EXPECT_EQ(rows[1].section, "");
  EXPECT_EQ(rows[1].times, 3);
  EXPECT_EQ(rows[3].section, "C");
  EXPECT_EQ(rows[3].path, (std::vector<int>{1, 1}));
  item_at(items, rows[3].path).times = 7;
  list_of(items, rows[2].path).erase(list_of(items, rows[2].path).begin());
  EXPECT_EQ(order_text(items), "A 4x, (C 7x) 3x, D");
}

TEST(Sections, NamesCannotBeCounts) {
  EXPECT_EQ(section_name(" left border "), "left_border");
  EXPECT_EQ(section_name("4x"), "S4x");
  EXPECT_EQ(section_name("(a)"), "a");
  EXPECT_EQ(section_name(" , "), "");
  Assembly some;
  EXPECT_EQ(free_section_name(some), "A");
  some = with_section(some, {"A", {}, {}, {}});
  EXPECT_EQ(free_section_name(some), "B");
}

/// Ends 1..8 on shafts 1..4 and back, the first half in colour 1.
Design draw() {
  Design d;
  d.draft = blank_draft(8, 4, 4, 4);
  for (int i = 0; i < 8; ++i) d.draft.threading.set(i, i < 4 ? i : 7 - i, true);
  for (int i = 0; i < 4; ++i) d.draft.warp.color[static_cast<size_t>(i)] = 1;
  for (int i = 0; i < 4; ++i) d.draft.treadling.set(i, i, true), d.draft.tieup.set(i, i, true);
  return d;
}

Assembly both(const Design& d, std::string order) {
  Assembly a;
  a = with_section(std::move(a), section_of(d, {System::kWarp, 0, 4}, "Up"));
  a = with_section(std::move(a), section_of(d, {System::kWarp, 4, 8}, "Down"));
  a.order = std::move(order);
  return a;
}

std::string shafts(const Design& d) {
  std::string text;
  for (int i = 0; i < d.draft.ends(); ++i) text += static_cast<char>('1' + d.draft.threading.first(i));
  return text;
}

TEST(Sections, TheOrderMakesTheThreads) {
  const Design d = draw();
  const auto made = assembled(d, System::kWarp, both(d, "Up 2x (Up Down) Up"));
  ASSERT_TRUE(made) << problem_of(made);
  EXPECT_EQ(shafts(*made), "12341234123443211234");
  EXPECT_TRUE(is_consistent(*made));
  EXPECT_EQ(made->draft.warp.color[12], 0);
  EXPECT_EQ(made->draft.warp.color[16], 1);
  EXPECT_EQ(made->warp_assembly.order, "Up 2x (Up Down) Up");
  EXPECT_EQ(assembled_threads(made->warp_assembly, read_order("Up 9x").value()), 36);
}

TEST(Sections, AreReversedAndReflected) {
  const Design d = draw();
  const auto made = [&](const char* order) {
    const auto design = assembled(d, System::kWarp, both(d, order));
    EXPECT_TRUE(design) << problem_of(design);
    EXPECT_EQ(assembled_threads(both(d, order), read_order(order).value()), design->draft.ends()) << order;
    return shafts(*design);
  };
  EXPECT_EQ(made("Up Up'"), "12344321");
  EXPECT_EQ(made("Up<> 2x"), "123432123432") << "turns on single threads, where repeats join, too";
  EXPECT_EQ(made("(Up 2x)'"), "43214321");
  EXPECT_EQ(made("(Up Down')'"), "43214321");
  const auto colors = assembled(d, System::kWarp, both(d, "(Up Down)'"));
  EXPECT_EQ(colors->draft.warp.color, (std::vector<int>{0, 0, 0, 0, 1, 1, 1, 1})) << "colours go with the threads";
}

TEST(Sections, AChangedSectionRemakesTheThreads) {
  const Design d = draw();
  Design made = assembled(d, System::kWarp, both(d, "Up Down Up")).value();
  Design other = d;
  for (int i = 0; i < 4; ++i) other.draft.threading.set(i, i, false), other.draft.threading.set(i, 3, true);
  const Assembly changed = with_section(made.warp_assembly, section_of(other, {System::kWarp, 0, 2}, "Up"));
  EXPECT_EQ(changed.sections.size(), 2u) << "replaces the section of its name";
  made = assembled(made, System::kWarp, changed).value();
  EXPECT_EQ(shafts(made), "44432144");
}

TEST(Sections, PicksFollowTheShedControl) {
  Design d = draw();
  Assembly a = with_section({}, section_of(d, {System::kWeft, 0, 2}, "A"));
  a.order = "A 3x";
  const auto made = assembled(d, System::kWeft, a);
  ASSERT_TRUE(made) << problem_of(made);
  EXPECT_EQ(made->draft.picks(), 6);
  EXPECT_TRUE(made->draft.treadling.get(5, 1));
  EXPECT_TRUE(is_consistent(*made));
  d.draft.shed_control = ShedControl::kLiftplan;
  d.draft.treadling = BitMatrix(4, 4);
  EXPECT_FALSE(assembled(d, System::kWeft, a)) << "sections with treadles cannot make a liftplan";
}

TEST(Sections, ImpossibleOrdersLeaveTheDraft) {
  const Design d = draw();
  for (const char* order : {"Up (", "Sideways", "Up 100000x 100000x", "(((Up 99999x) 99999x) 99999x)"}) {
    EXPECT_FALSE(assembled(d, System::kWarp, both(d, order))) << order;
  }
  const auto none = assembled(d, System::kWarp, both(d, ""));
  ASSERT_TRUE(none) << problem_of(none);
  EXPECT_EQ(none->draft, d.draft) << "without an order the threads stay and the sections are stored";
  EXPECT_EQ(none->warp_assembly.sections.size(), 2u);
}

TEST(Sections, MissingColoursAndYarnsBecomeTheFirst) {
  Design d = draw();
  Assembly a = both(d, "Up");
  a.sections[0].threads.color[0] = 77;
  a.sections[0].threads.yarn[1] = 9;
  EXPECT_TRUE(is_consistent(assembled(d, System::kWarp, a).value()));
}

}  // namespace
}  // namespace weftlight::weaves
