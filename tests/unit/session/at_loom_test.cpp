// Weaving at a loom: the place in the design, steps by hand, and a mock loom whose connection is lost.

#include "session/loom/at_loom.h"

#include <gtest/gtest.h>
#include <poll.h>
#include <unistd.h>

#include <chrono>
#include <thread>

#include "../comes_true.h"
#include "../hanging_lookup.h"
#include "../loom_port.h"
#include "../loom_terminal.h"
#include "../scratch.h"
#include "../straight_draft.h"
#include "design/edits.h"
#include "draft/drawdown.h"
#include "session/document/document.h"
#include "session/loom/cloth_so_far.h"
#include "session/loom/loom_link.h"
#include "session/loom/shown_step.h"

namespace weftlight::session {

using design::Design, design::to_liftplan;

namespace {

void take(Design& d, const LoomStep& step) {
  if (step.edit) d = step.edit->apply(std::move(d));
}

ShownStep shown(const AtLoom& at, const Design& d) { return shown_step(at, d, draft::lifts(d.draft), loom_groups(d)); }

TEST(AtLoom, AStepByHandWeavesOnePickAndTheDraftKeepsThePlace) {
  AtLoom at;
  Design d = straight_draft(4);
  for (const int next : {1, 2, 3, 0, 1}) {
    take(d, step_by_hand(at, d, true, false));
    EXPECT_EQ(d.loom.next_pick, next);
  }
  EXPECT_EQ(at.place.woven, 5);
  take(d, step_by_hand(at, d, false, false));
  EXPECT_EQ(d.loom.next_pick, 0);
  EXPECT_EQ(at.place.woven, 4);
}

TEST(AtLoom, UndoLeavesThePlace) {
  AtLoom at;
  Document draft(straight_draft(8));
  const auto woven = [&] {
    const LoomStep step = step_by_hand(at, draft.now(), true, false);
    ASSERT_TRUE(step.edit);
    EXPECT_TRUE(draft.commit(*step.edit, 0));
  };
  draft.commit({"Paint", [](Design d) { return design::with_tieup(std::move(d), 0, 3, true); }}, 1);
  for (int pick = 0; pick < 4; ++pick) woven();
  EXPECT_EQ(shown(at, draft.now()).progress, "Woven: 4 picks");
  EXPECT_EQ(draft.history().undo_label(), "Paint") << "a pick is no step of undo";
  EXPECT_TRUE(draft.undo());
  EXPECT_FALSE(draft.now().draft.tieup.get(0, 3));
  EXPECT_EQ(shown(at, draft.now()).number, 5);
  EXPECT_EQ(shown(at, draft.now()).progress, "Woven: 4 picks");
  woven();
  EXPECT_TRUE(draft.redo()) << "weaving drops no step";
  EXPECT_EQ(shown(at, draft.now()).number, 6);
}

TEST(AtLoom, ASectionRepeats) {
  AtLoom at;
  Design d = straight_draft(4);
  take(d, keep_to_section(at, d, {1, 3}));
  EXPECT_EQ(d.loom.next_pick, 1) << "it begins where the section does";
  for (const int next : {2, 1, 2}) {
    take(d, step_by_hand(at, d, true, false));
    EXPECT_EQ(d.loom.next_pick, next);
  }
  take(d, go_to_pick(at, d, 0));
  EXPECT_EQ(d.loom.next_pick, 1);
}

TEST(AtLoom, EditsMoveThePlace) {
  AtLoom at;
  Design d = straight_draft(4);
  d.loom.next_pick = 2;  // from the file
  EXPECT_EQ(place_of(at, d).next_pick, 2);
  d.loom.next_pick = 90;
  EXPECT_EQ(place_of(at, d).next_pick, 3) << "the draft has become shorter";
}

TEST(AtLoom, WithALoomTheFirstStepRaisesTheShownPick) {
  AtLoom at;
  Design d = straight_draft(4);
  LoomStep step = step_by_hand(at, d, true, true);
  EXPECT_EQ(step.send, "C00000001\n");
  EXPECT_FALSE(step.edit);
  step = step_by_hand(at, d, true, true);
  EXPECT_EQ(step.send, "C00000002\n");
  take(d, step);
  EXPECT_EQ(d.loom.next_pick, 1);
}

TEST(AtLoom, TreadlesToPressOrShaftsToLift) {
  Design d = straight_draft(4);
  d.draft.treadling.set(2, 0, true);
  EXPECT_EQ(to_press(d.draft, 2), (std::vector<int>{0, 2}));
  EXPECT_TRUE(to_press(d.draft, 9).empty());
  EXPECT_EQ(to_press(to_liftplan(d).draft, 1), std::vector<int>{1});
}

TEST(AtLoom, ThreadsEndByEndAndKeepsThePlace) {
  AtLoom at;
  at.work = LoomWork::kThread;
  Design d = straight_draft(4);
  for (const int next : {1, 2, 3, 4, 4}) {
    take(d, step_by_hand(at, d, true, false));
    EXPECT_EQ(d.loom.next_end, next);
  }
  EXPECT_TRUE(shown(at, d).done());
  EXPECT_EQ(shown(at, d).what, "All ends are threaded");
  take(d, step_by_hand(at, d, false, false));
  const ShownStep last = shown(at, d);
  EXPECT_EQ(last.number, 4);
  EXPECT_EQ(last.what, "Shaft 4");
  EXPECT_EQ(last.shafts, (std::vector<bool>{false, false, false, true}));
  take(d, go_to(at, d, 1));
  EXPECT_EQ(shown(at, d).number, 2);
  EXPECT_EQ(d.loom.next_pick, 0) << "weaving has a place of its own";
  d.draft.threading.set(1, 1, false);
  EXPECT_EQ(shown(at, d).what, "No heddle");
}

TEST(AtLoom, SleysByTheReedOfThePlan) {
  AtLoom at;
  at.work = LoomWork::kSley;
  Design d = straight_draft(5);
  d.plan.sleying = {2, 1, 0};
  EXPECT_EQ(dents_on_loom(d), 4) << "2 1 0 2, and none is empty at the end";
  std::vector<std::string> texts;
  for (int i = 0; i < 5; ++i) {
    texts.push_back(shown(at, d).what);
    take(d, step_by_hand(at, d, true, false));
  }
  EXPECT_EQ(texts,
            (std::vector<std::string>{"Ends 1 and 2", "End 3", "Leave empty", "Ends 4 and 5", "All dents are sleyed"}));
  d.plan.floating_selvedges = true;
  EXPECT_EQ(dents_on_loom(d), 6);
  take(d, go_to(at, d, 0));
  EXPECT_EQ(shown(at, d).what, "Floating selvedge");
  EXPECT_EQ(ends_in_dent(d, 1).count, 2);
  EXPECT_TRUE(ends_in_dent(d, 5).floating);
}

TEST(AtLoom, SectionsAreThoseOfTheOrderOrTheRepeats) {
  Design d = straight_draft(4);
  EXPECT_EQ(group_text(groups_of_ends(d), draft::System::kWarp, 2), "") << "one section says nothing";
  d.plan.width_mm = 39;
  d.plan.ends_per_cm = 3;
  d.plan.warp_shrinkage = d.plan.weft_shrinkage = 0;
  ASSERT_EQ(ends_on_loom(d), 12) << "three times the draft";
  EXPECT_EQ(group_text(groups_of_ends(d), draft::System::kWarp, 6), "Section 2 of 3: end 3 of 4");
  design::ThreadSection section{"A", draft::BitMatrix(2, 4), {}};
  section.threads.resize(2);
  d.weft_assembly = {{section}, "A 2x"};
  EXPECT_EQ(group_text(groups_of_picks(d), draft::System::kWeft, 3), "Section 2 of 2 (A): pick 2 of 2");
  d.weft_assembly.order = "A 3x";
  EXPECT_EQ(groups_of_picks(d).size(), 1u) << "the picks are no longer as the order made them";
}

TEST(AtLoom, ATabbyPickIsKeptWithTheDraft) {
  AtLoom at;
  Design d = straight_draft(4);
  take(d, step_by_hand(at, d, true, false));
  take(d, give_tabby(at, d, false));
  EXPECT_TRUE(d.loom.at_tabby);
  EXPECT_EQ(shown(at, d).heading, "Tabby A before pick");
  EXPECT_EQ(shown(at, d).what, "Treadle 1 + 3");
  EXPECT_EQ(shown(AtLoom{}, d).shafts, (std::vector<bool>{true, false, true, false})) << "in another window, too";
  take(d, step_by_hand(at, d, true, false));
  EXPECT_FALSE(d.loom.at_tabby);
  EXPECT_EQ(shown(at, d).number, 2) << "back to the pattern";
  const LoomStep between = put_tabby_between(at, d, true);
  ASSERT_TRUE(between.edit);
  EXPECT_EQ(between.edit->label, "Add tabby between pattern picks");
  EXPECT_EQ(put_tabby_between(at, d, false).edit->label, "Remove tabby between pattern picks");
  take(d, between);
  take(d, step_by_hand(at, d, true, false));
  EXPECT_EQ(shown(at, d).heading, "Tabby B before pick");
  EXPECT_EQ(d.loom.next_pick, 2);
  d.draft.threading.set(1, 0, true);
  EXPECT_EQ(shown(at, d).heading, "Pick") << "the threading was changed";
  take(d, give_tabby(at, d, false));
  EXPECT_FALSE(d.loom.at_tabby);
  EXPECT_FALSE(at.remark.empty());
}

TEST(AtLoom, ThePictureOfTheClothGrowsToItsLimit) {
  const AtLoom at;
  Design d = straight_draft(4);
  const draft::BitMatrix cells = draft::drawdown(d.draft);
  const auto height = [](const std::string& png) {
    return png.size() < 24 ? 0 : static_cast<unsigned char>(png[22]) * 256 + static_cast<unsigned char>(png[23]);
  };
  EXPECT_EQ(height(cloth_so_far_png(at, d, cells)), 48) << "the bare warp";
  d.loom.next_pick = 3;
  EXPECT_EQ(height(cloth_so_far_png(at, d, cells)), 60);
  AtLoom round;
  round.place = {.next_pick = 3, .woven = 100000};
  EXPECT_EQ(height(cloth_so_far_png(round, d, cells)), 432);
}

std::string read_line(int fd) {
  std::string line;
  for (char c; ::read(fd, &c, 1) == 1 && c != '\n';) line += c;
  return line;
}

/// The window's part: greets, hears, answers.
struct Weaver {
  AtLoom at{};
  Design design = straight_draft(4);
  LoomLink link{[] {}};
  int greeted = 0;

  void poll() {
    const LoomLink::Received received = link.take();
    const auto carry_out = [this](const LoomStep& step) {
      link.send(step.send);
      take(design, step);
    };
    greeted += received.connected;
    if (received.connected) carry_out(greet(at, design));
    for (const loom::LoomReport& report : received.reports) carry_out(hear(at, design, report));
  }
};

TEST(LoomLink, AfterALostConnectionWeavingContinuesAtTheSamePick) {
  const LoomPort port;
  Weaver w;
  w.link.connect(port.address());
  int loom = port.accepted();
  ASSERT_TRUE(comes_true([&] {
    w.poll();
    return w.greeted == 1;
  }));
  EXPECT_EQ(read_line(loom), "U0");
  const auto ask = [&](int picks_so_far, const char* shafts) {
    ASSERT_EQ(::write(loom, "p\n", 2), 2);
    ASSERT_TRUE(comes_true([&] {
      w.poll();
      return w.at.place.waiting && w.at.place.woven == picks_so_far;
    }));
    EXPECT_EQ(read_line(loom), shafts);
  };
  ASSERT_NO_FATAL_FAILURE(ask(0, "C00000001"));
  ASSERT_NO_FATAL_FAILURE(ask(1, "C00000002"));
  ::close(loom);
  ASSERT_TRUE(comes_true([&] { return w.link.state() == LoomLink::State::kConnecting; }));
  loom = port.accepted();
  ASSERT_TRUE(comes_true([&] {
    w.poll();
    return w.greeted == 2;
  }));
  EXPECT_EQ(read_line(loom), "U0");
  EXPECT_EQ(read_line(loom), "C00000002") << "the pick that was on its way, once more";
  ASSERT_NO_FATAL_FAILURE(ask(2, "C00000004"));
  EXPECT_EQ(w.design.loom.next_pick, 2);
  w.link.disconnect();
  EXPECT_EQ(w.link.state(), LoomLink::State::kOff);
  ::close(loom);
}

TEST(LoomLink, ASerialConnectionResumesAtTheSamePick) {
  const Scratch scratch("serial");
  LoomTerminal loom(scratch / "loom");
  if (!loom.is_there()) GTEST_SKIP() << "this machine gives no pseudo-terminals";
  Weaver w;
  w.link.connect(loom.address());
  ASSERT_TRUE(comes_true([&] {
    w.poll();
    return w.greeted == 1;
  }));
  EXPECT_EQ(loom.heard(), "U0");
  const auto ask = [&](int picks_so_far, const char* shafts) {
    loom.say("p\n");
    ASSERT_TRUE(comes_true([&] {
      w.poll();
      return w.at.place.waiting && w.at.place.woven == picks_so_far;
    }));
    EXPECT_EQ(loom.heard(), shafts);
  };
  ASSERT_NO_FATAL_FAILURE(ask(0, "C00000001"));
  ASSERT_NO_FATAL_FAILURE(ask(1, "C00000002"));
  loom.pull_out();
  ASSERT_TRUE(comes_true([&] { return w.link.state() == LoomLink::State::kConnecting; }));
  loom.plug_in();
  ASSERT_TRUE(comes_true([&] {
    w.poll();
    return w.greeted == 2;
  }));
  EXPECT_EQ(loom.heard(), "U0");
  EXPECT_EQ(loom.heard(), "C00000002") << "the pick that was on its way, once more";
  ASSERT_NO_FATAL_FAILURE(ask(2, "C00000004"));
  EXPECT_EQ(w.design.loom.next_pick, 2);
}

TEST(LoomLink, EndsWhileTheNameOfALoomIsLookedUp) {
  const HangingLookup names;
  {
    LoomLink link([] {}, names.look_up());
    link.connect("tcp:loom.invalid:7388");
    ASSERT_TRUE(names.is_asked());
  }
  EXPECT_FALSE(names.answered()) << "it waited for the name server";
  names.answer({});
}

TEST(LoomLink, WhatIsNoMessageMovesNoPickAndIsTold) {
  const LoomPort port;
  Weaver w;
  w.link.connect(port.address());
  const int loom = port.accepted();
  const auto says = [&](const std::string& bytes) {
    ASSERT_EQ(::write(loom, bytes.data(), bytes.size()), static_cast<ssize_t>(bytes.size()));
  };
  const auto tells = [&](const std::string& words) {
    return comes_true([&] {
      w.poll();
      return w.at.remark.find(words) != std::string::npos;
    });
  };
  says("p\n");
  ASSERT_TRUE(comes_true([&] {
    w.poll();
    return w.at.place.waiting;
  }));
  const loom::WeavingState before = w.at.place;
  says(std::string("\x01\xff\xfe\0p!", 6) + "\n");
  EXPECT_TRUE(tells("????p!")) << w.at.remark;
  // A line without end, longer than all that lies between the two.
  std::thread endless([loom] {
    const std::string part(65536, 'p');
    for (int i = 0; i < 256; ++i)
      if (::write(loom, part.data(), part.size()) <= 0) return;
  });
  EXPECT_TRUE(tells(std::string(loom::LoomReader::kMaxLineBytes, 'p'))) << w.at.remark;
  endless.join();
  EXPECT_EQ(w.at.place, before) << "no pick was asked for";
  // A message that comes byte by byte is still one.
  says("\n");
  for (const char* byte : {"p", "\r", "\n"}) {
    says(byte);
    std::this_thread::sleep_for(std::chrono::milliseconds(60));
    w.poll();
  }
  EXPECT_TRUE(comes_true([&] {
    w.poll();
    return w.at.place.woven == before.woven + 1;
  }));
  ::close(loom);
}

TEST(LoomLink, OneThatHangsUpAtOnceIsCalledAgainAndTold) {
  const LoomPort port;
  Weaver w;
  w.link.connect(port.address());
  for (int i = 0; i < 2; ++i) {
    ::close(port.accepted());
    ASSERT_TRUE(comes_true([&] { return !w.link.why().empty(); })) << "nobody says why";
    EXPECT_EQ(w.at.place, loom::WeavingState{});
  }
}

TEST(LoomLink, AFloodFromTheLoomIsNotHoarded) {
  const LoomPort port;
  LoomLink link([] {});
  link.connect(port.address());
  const int loom = port.accepted();
  std::string flood;
  for (int i = 0; i < 100000; ++i) flood += "p\n";
  // Nobody takes the reports: the loom can write only until the buffers between the two are full.
  size_t written = 0;
  const timeval patience{1, 0};
  ::setsockopt(loom, SOL_SOCKET, SO_SNDTIMEO, &patience, sizeof patience);
  for (ssize_t n; written < (size_t{256} << 20) && (n = ::write(loom, flood.data(), flood.size())) > 0;)
    written += static_cast<size_t>(n);
  EXPECT_LT(written, size_t{256} << 20) << "all was read";
  EXPECT_LE(link.take().reports.size(), LoomLink::kMaxReports + platform::Line::kMaxReceived);
  size_t more = 0;
  EXPECT_TRUE(comes_true([&] { return (more += link.take().reports.size()) > 0; })) << "what is taken makes room";
  ::close(loom);
}

TEST(LoomLink, ReportsWhyItCannotConnect) {
  LoomLink link([] {});
  link.connect("somewhere");
  ASSERT_TRUE(comes_true([&] { return !link.why().empty(); }));
  EXPECT_NE(link.why().find("somewhere"), std::string::npos) << "the address as it was given: " << link.why();
  EXPECT_NE(link.why().find("tcp:HOST:PORT"), std::string::npos) << "how an address is written: " << link.why();
  EXPECT_EQ(link.state(), LoomLink::State::kConnecting) << "it goes on trying";
  link.connect("");
  EXPECT_EQ(link.state(), LoomLink::State::kOff);
}

}  // namespace
}  // namespace weftlight::session
