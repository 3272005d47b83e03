#include <gtest/gtest.h>

#include "session/editing/thread_choice.h"

namespace weftlight::session {

using design::Design, design::Yarn;
using draft::System, draft::blank_draft;

namespace {

using Indices = std::vector<int>;

Design striped() {
  Design d;
  d.draft = blank_draft(6, 4, 2, 2);
  for (int i : {1, 3, 5}) d.draft.warp.color[static_cast<size_t>(i)] = 1;
  d.yarns.push_back(Yarn{});
  d.yarns[0].diameter_mm = 0.5f;
  d.yarns[1].diameter_mm = 2;
  d.draft.warp.yarn[3] = 1;
  return d;
}

TEST(ThreadChoice, APressChoosesOneThreadADragARange) {
  ThreadChoice c;
  begin_choice(c, System::kWarp, 4, Choose::kOnly);
  EXPECT_EQ(c.threads, Indices{4});
  drag_choice(c, 2);
  EXPECT_EQ(c.threads, (Indices{2, 3, 4}));
  drag_choice(c, 5);
  EXPECT_EQ(c.threads, (Indices{4, 5})) << "a drag that turns back gives up what it left";
  c.dragging = false;
  drag_choice(c, 0);
  EXPECT_EQ(c.threads, (Indices{4, 5}));
}

TEST(ThreadChoice, ShiftExtendsAndCtrlAddsOrRemoves) {
  ThreadChoice c;
  begin_choice(c, System::kWarp, 1, Choose::kOnly);
  begin_choice(c, System::kWarp, 3, Choose::kRange);
  EXPECT_EQ(c.threads, (Indices{1, 2, 3}));
  begin_choice(c, System::kWarp, 0, Choose::kRange);
  EXPECT_EQ(c.threads, (Indices{0, 1})) << "the range turns about its first thread";
  begin_choice(c, System::kWarp, 4, Choose::kAlso);
  drag_choice(c, 5);
  EXPECT_EQ(c.threads, (Indices{0, 1, 4, 5}));
  begin_choice(c, System::kWarp, 1, Choose::kAlso);
  drag_choice(c, 4);
  EXPECT_EQ(c.threads, (Indices{0, 5})) << "from a chosen thread it takes away";
  begin_choice(c, System::kWeft, 2, Choose::kAlso);
  EXPECT_EQ(c.system, System::kWeft);
  EXPECT_EQ(c.threads, Indices{2}) << "warp and weft are not chosen at once";
}

TEST(ThreadChoice, AThreadIsNamedAsWeaversTypeIt) {
  const auto named = [](std::string_view words) {
    const std::optional<NamedThread> read = named_thread(words);
    if (!read) return std::string("none");
    const std::string system = !read->system ? "" : *read->system == System::kWarp ? "end " : "pick ";
    return system + std::to_string(read->number);
  };
  EXPECT_EQ(named("120"), "120");
  EXPECT_EQ(named(" 7 "), "7");
  for (const char* end : {"e120", "E120", "end 120", "ends120", "e 120"}) EXPECT_EQ(named(end), "end 120") << end;
  for (const char* pick : {"p40", "P40", "pick 40", "Picks 40"}) EXPECT_EQ(named(pick), "pick 40") << pick;
  EXPECT_EQ(named("99999999999"), "2147483647");
  for (const char* none : {"", "e", "pick", "x12", "12e", "1-3", "-4", "endless 3", "1.5"})
    EXPECT_EQ(named(none), "none") << none;
}

TEST(ThreadChoice, AnEmptyChoiceMeansAllAndDeletedThreadsAreDropped) {
  const Design d = striped();
  ThreadChoice c;
  EXPECT_EQ(concerned(c, d.draft).size(), 6u);
  c.threads = {2, 5, 9};
  limit_choice(c, d.draft);
  EXPECT_EQ(concerned(c, d.draft), (Indices{2, 5}));
}

TEST(ThreadChoice, SimilarThreadsHaveTheSameColourAndYarn) {
  const Design d = striped();
  EXPECT_EQ(threads_alike(d.draft, System::kWarp, {1}), (Indices{1, 5}));
  EXPECT_EQ(threads_alike(d.draft, System::kWarp, {0, 3}), (Indices{0, 2, 3, 4}));
}

TEST(ThreadWords, RangesAndStepsAreWrittenAndReadAgain) {
  EXPECT_EQ(words_of_threads({2, 3, 4, 5, 6, 11}), "3-7, 12");
  EXPECT_EQ(words_of_threads({0, 2, 4, 6}), "1-7/2");
  EXPECT_EQ(words_of_threads({0, 1}), "1, 2");
  EXPECT_EQ(words_of_threads({}), "");
  for (const Indices& threads : {Indices{0}, Indices{0, 1, 2, 8, 10, 12, 13}, Indices{3, 6, 9, 10, 11, 19}})
    EXPECT_EQ(threads_of_words(words_of_threads(threads), 20), threads);
}

TEST(ThreadWords, ReadsTypedLists) {
  EXPECT_EQ(threads_of_words(" 7 - 3,12 ", 20), (Indices{2, 3, 4, 5, 6, 11}));
  EXPECT_EQ(threads_of_words("3\xE2\x80\x93"
                             "5",
                             20),
            (Indices{2, 3, 4}));
  EXPECT_EQ(threads_of_words("Odd", 5), (Indices{0, 2, 4}));
  EXPECT_EQ(threads_of_words("4-", 6), (Indices{3, 4, 5}));
  EXPECT_EQ(threads_of_words("4-/2", 9), (Indices{3, 5, 7}));
  EXPECT_EQ(threads_of_words("5-99", 6), (Indices{4, 5})) << "up to the last thread";
  EXPECT_EQ(threads_of_words("", 6), Indices{});
  EXPECT_EQ(threads_of_words("3,", 6), Indices{2}) << "still being typed";
  for (const char* bad : {"x", "0", "7", "3--4", "1-4/0", "2/", "-3", "99999999999", "1-4/x"})
    EXPECT_FALSE(threads_of_words(bad, 6)) << bad;
}

TEST(SharedThreads, MixedValuesShowTheirRange) {
  Design d = striped();
  SharedThreads s = shared_by(d, System::kWarp, {0, 1, 2});
  EXPECT_FALSE(s.thickness.mixed());
  EXPECT_EQ(s.thickness.own, 0);
  EXPECT_FLOAT_EQ(s.thickness.low, 0.5f) << "the yarn's";
  EXPECT_GE(s.spacing.low, 0.5f) << "room for the thread where the draft gives none";
  d.draft.warp.thickness_mm[1] = 1.5f;
  s = shared_by(d, System::kWarp, {0, 1, 3});
  EXPECT_TRUE(s.thickness.mixed());
  EXPECT_FLOAT_EQ(s.thickness.low, 0.5f);
  EXPECT_FLOAT_EQ(s.thickness.high, 2);
  EXPECT_EQ(s.thickness.own, 1);
  EXPECT_TRUE(s.yarn.mixed());
  EXPECT_EQ(s.color.value, 0);
  EXPECT_EQ(s.color.others, Indices{1});
  EXPECT_EQ(thread_label(ThreadProperty::kThickness, System::kWarp, 3), "Change thickness of 3 ends");
  EXPECT_EQ(thread_label(ThreadProperty::kYarn, System::kWeft, 1), "Change yarn of 1 pick");
}

}  // namespace
}  // namespace weftlight::session
