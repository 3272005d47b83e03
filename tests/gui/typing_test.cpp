// Dialogs are typed into as soon as they open, by real keys.

#include <gtest/gtest.h>

#include <memory>

#include "on_display.h"

namespace weftlight::gui {
namespace {

class TypingTest : public OnDisplay {
 protected:
  void SetUp() override {
    OnDisplay::SetUp();
    if (IsSkipped() || HasFatalFailure()) return;
    window_ = std::make_unique<Window>(display_, folder_, draft_, without_dialogs());
    ASSERT_TRUE(comes_true([&] { return window_->is_ready(); }));
  }
  /// Runs the action; returns once its dialog shows the control.
  void open(const std::string& words, const std::string& control) const {
    ASSERT_NO_FATAL_FAILURE(command(*window_, words));
    ASSERT_TRUE(comes_true([&] { return window_->has(control); })) << words;
  }
  void enter(const std::string& text) const {
    display_.type(text);
    display_.key("Return");
  }
  design::Design now() const { return design_of(window_->live()); }

  std::unique_ptr<Window> window_;
};

TEST_F(TypingTest, TheSizeOfTheDraft) {
  ASSERT_NO_FATAL_FAILURE(open("size and loom", "size.ends"));
  enter("31");
  EXPECT_TRUE(comes_true([&] { return now().draft.ends() == 31; })) << now().draft.ends();
}

TEST_F(TypingTest, TitleAndNotes) {
  ASSERT_NO_FATAL_FAILURE(open("title and notes", "notes.title"));
  enter("Scarf");
  EXPECT_TRUE(comes_true([&] { return now().title == "Scarf"; })) << now().title;
}

TEST_F(TypingTest, AThreadToGoTo) {
  const Window& w = *window_;
  display_.key("ctrl+g");
  ASSERT_TRUE(comes_true([&] { return w.has("goto.number"); }));
  display_.type("p40");
  EXPECT_TRUE(comes_true([&] { return w.has("goto.none"); })) << "there are 24 picks";
  display_.key("Return");
  EXPECT_TRUE(w.has("goto.number")) << "it goes nowhere";
  display_.key("ctrl+a");
  display_.type("p14");
  EXPECT_TRUE(comes_true([&] { return !w.has("goto.none"); }));
  display_.key("Return");
  ASSERT_TRUE(comes_true([&] { return !w.has("goto.number"); }));
  display_.key("ctrl+g");
  ASSERT_TRUE(comes_true([&] { return w.has("goto.number"); }));
  enter("25");
  EXPECT_TRUE(w.has("goto.none")) << "picks as before, of which there are 24";
  display_.key("Escape");
}

TEST_F(TypingTest, APickToGoToAtTheLoom) {
  const Window& w = *window_;
  display_.key("F9");
  ASSERT_TRUE(comes_true([&] { return w.has("loom.pick:1"); }));
  display_.key("ctrl+g");
  ASSERT_TRUE(comes_true([&] { return w.has("goto.number"); }));
  enter("9");
  EXPECT_TRUE(comes_true([&] { return w.has("loom.pick:9"); }));
  EXPECT_TRUE(comes_true([&] { return now().loom.next_pick == 8; })) << "it is saved with the draft";
  display_.key("ctrl+g");
  ASSERT_TRUE(comes_true([&] { return w.has("goto.number"); }));
  enter("e5");
  EXPECT_TRUE(comes_true([&] { return w.has("loom.place"); })) << "the ends are threaded";
}

TEST_F(TypingTest, ThreadsOfAGradient) {
  ASSERT_NO_FATAL_FAILURE(open("gradient", "gradient.from"));
  display_.key("ctrl+a");
  display_.type("ff0000");
  ASSERT_NO_FATAL_FAILURE(press(*window_, "Apply"));
  EXPECT_TRUE(comes_true([&] {
    const auto& d = now().draft;
    return d.palette[static_cast<size_t>(d.warp.color[0])] == draft::Rgb{1, 0, 0};
  }));
}

TEST_F(TypingTest, ARangeForASection) {
  ASSERT_NO_FATAL_FAILURE(open("build from sections", "sections.first"));
  display_.type("5");
  display_.key("Tab");
  display_.type("8");
  ASSERT_NO_FATAL_FAILURE(click(*window_, "sections.take"));
  ASSERT_TRUE(comes_true([&] { return window_->has("sections.add:1"); }));
  ASSERT_NO_FATAL_FAILURE(click(*window_, "sections.add:1"));
  ASSERT_NO_FATAL_FAILURE(press(*window_, "Apply"));
  EXPECT_TRUE(comes_true([&] { return now().draft.ends() == 4; })) << now().draft.ends();
}

TEST_F(TypingTest, NamesOfVersionsAndViews) {
  ASSERT_NO_FATAL_FAILURE(open("versions and colour", "versions.name"));
  enter("In blue");
  EXPECT_TRUE(comes_true([&] { return now().versions.size() == 1 && now().versions[0].name == "In blue"; }));
  display_.key("Escape");
  ASSERT_TRUE(comes_true([&] { return !window_->has("versions.name"); }));
  ASSERT_NO_FATAL_FAILURE(open("save view as", "dialog.name"));
  enter("From the left");
  ASSERT_TRUE(comes_true([&] { return now().views.size() == 1 && now().views[0].name == "From the left"; }));
  ASSERT_NO_FATAL_FAILURE(open("rename or delete views", "names:1"));
  display_.key("ctrl+a");
  display_.type("Left");
  ASSERT_NO_FATAL_FAILURE(press(*window_, "Done"));
  EXPECT_TRUE(comes_true([&] { return now().views[0].name == "Left"; }));
}

TEST_F(TypingTest, TheWeaveOfANewDraft) {
  display_.key("ctrl+n");
  ASSERT_TRUE(comes_true([&] { return window_->has("weave.find"); }));
  display_.type("satin");
  EXPECT_TRUE(comes_true([&] { return window_->has("weave:satin") && !window_->has("weave:plain"); }));
  display_.key("Escape");
}

}  // namespace
}  // namespace weftlight::gui
