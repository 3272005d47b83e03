#include "session/tab_names.h"

#include <memory>

#include "../scratch_fixture.h"
#include "wif/wif.h"

namespace weftlight::session {

using design::Design;

namespace {

using Names = std::vector<std::string>;

class TabNamesTest : public ScratchTest {
 protected:
  static Document untitled() {
    Design d;
    d.draft = draft::blank_draft(8, 8, 4, 4);
    return Document(d);
  }
  uint64_t add_new() { return session_->add(untitled(), Origin::kOwn).id; }
  uint64_t add_file(const std::string& name) {
    const std::string file = written(name, wif::write_new_wif(untitled().now()));
    return session_->add(std::move(*open_document(file).document), Origin::kOwn).id;
  }
  void SetUp() override {
    ScratchTest::SetUp();
    session_ = std::make_unique<Session>(path("recovery"), untitled());
  }

  std::unique_ptr<Session> session_;
};

TEST_F(TabNamesTest, DraftsWithoutAFileAreNumberedAsTheyWereOpened) {
  const uint64_t first = add_new(), second = add_new();
  const uint64_t file = add_file("twill.wif");
  EXPECT_EQ(tab_name(*session_, first), "Untitled");
  EXPECT_EQ(tab_name(*session_, second), "Untitled 2");
  EXPECT_EQ(tab_name(*session_, file), "twill.wif");
  session_->move(second, 0);
  EXPECT_EQ(tab_names(*session_).front(), "Untitled 2") << "a moved tab keeps its name";
  EXPECT_EQ(tab_name(*session_, 999), "");
}

TEST_F(TabNamesTest, WhatWasNeverSavedIsLostWhole) {
  const uint64_t fresh = add_new(), other = add_new(), file = add_file("twill.wif");
  const auto lost = [&](std::initializer_list<uint64_t> unsaved) {
    return loss_text(*session_, std::vector<uint64_t>(unsaved));
  };
  EXPECT_EQ(lost({file}), "Your changes since the last save would be lost.");
  EXPECT_EQ(lost({fresh}), "It has not been saved yet and would be lost.");
  EXPECT_EQ(lost({fresh, other}), "Whatever has not been saved would be lost.");
  EXPECT_EQ(lost({fresh, file}), "Whatever has not been saved would be lost.");
}

}  // namespace
}  // namespace weftlight::session
