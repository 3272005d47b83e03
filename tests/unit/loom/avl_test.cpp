// The Compu-Dobby of AVL, as its line is published: a loom that takes the shafts of the next pick while a shed is open.

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "../hand_drafts.h"
#include "draft/drawdown.h"
#include "loom/weaving.h"

namespace weftlight::loom {

using design::treadled;

namespace {

/// What a Compu-Dobby does with what it is sent, and what it says when the weaver treadles.
class MockAvl {
 public:
  explicit MockAvl(Protocol protocol) : protocol_(protocol) {}

  /// What it answers.
  std::string hear(const std::string& bytes) {
    std::string said;
    for (const char c : bytes) {
      message_ += c;
      if (protocol_ == Protocol::kAvl4 ? c == '\r' : c == '\x07' || message_ == "\x0f\x03")
        said += answer(std::exchange(message_, {}));
    }
    return said;
  }
  std::string close_shed() {
    fixed_ = sent_;
    return protocol_ == Protocol::kAvl4 ? "<UP>" : "\x61\x03";
  }
  std::string open_shed() {
    sheds.push_back(fixed_);
    return protocol_ == Protocol::kAvl4 ? "<DOWN>" : "\x62\x03";
  }
  std::vector<uint32_t> sheds;  // that were opened

 private:
  std::string answer(const std::string& message) {
    if (protocol_ == Protocol::kAvl4) return answer4(message);
    if (message == "\x0f\x03") return "\x7f\x03";
    sent_ = 0;
    for (const char c : message)
      if (const int byte = static_cast<unsigned char>(c); byte >= 0x10)
        sent_ |= static_cast<uint32_t>(byte & 15) << (4 * ((byte >> 4) - 1));
    return {};
  }
  std::string answer4(const std::string& message) {
    if (message == "\r") return "<Compu-Dobby IV, 24H, Pos Dobby, HW A.1, FW 0.1.0>\n\r<Password:>";
    if (message == "clear\r") sent_ = 0;
    for (size_t at = 5; message.starts_with("pick ") && at < message.size(); at = message.find_first_of(",\r", at) + 1)
      sent_ |= uint32_t{1} << (std::stoi(message.substr(at)) - 1);
    return "<ready>";
  }

  Protocol protocol_;
  std::string message_;
  uint32_t sent_ = 0, fixed_ = 0;
};

class Avl : public testing::TestWithParam<Protocol> {
 protected:
  draft::Draft draft_ =
      treadled({"1000", "0100", "0010", "0001"}, {"1100", "0110", "0011", "1001"}, {"1000", "0100", "0010", "0001"});
  draft::BitMatrix lifts_ = draft::lifts(draft_);
  WeavingState state_;
  MockAvl loom_{GetParam()};
  LoomReader reader_{GetParam()};

  WeavingSetup setup() const { return {draft_, lifts_, {}, GetParam()}; }
  void take(LoomReply reply) {
    EXPECT_EQ(reply.remark, "");
    state_ = reply.state;
    if (!reply.send.empty()) said(loom_.hear(reply.send));
  }
  void said(const std::string& bytes) {
    for (const LoomReport& report : reader_.parse(bytes)) take(reply_to(setup(), state_, report));
  }
  /// Treadles to the next shed, and throws the shuttle.
  void weave() {
    said(loom_.close_shed());
    said(loom_.open_shed());
  }
  /// As a loom that takes picks ahead: after connecting, the empty shed is opened once.
  void weave_the_first_two() {
    take(on_connected(setup(), state_));
    said(loom_.open_shed());
    weave();
    weave();
    loom_.sheds.clear();
  }
  uint32_t shafts_of(int pick) const { return *raised_shafts(draft_, lifts_, pick); }
  std::vector<uint32_t> shafts_of(const std::vector<int>& picks) const {
    std::vector<uint32_t> out;
    for (const int pick : picks) out.push_back(shafts_of(pick));
    return out;
  }
};

TEST_P(Avl, OpensTheShedsOfTheDraftInOrder) {
  take(on_connected(setup(), state_));
  said(loom_.open_shed());  // the weaver opens the empty shed, so that the loom takes the first pick
  loom_.sheds.clear();
  for (const int pick : {0, 1, 2, 3, 0, 1}) {
    weave();
    EXPECT_EQ(state_.next_pick, pick) << "the window shows the pick whose shed is open";
  }
  EXPECT_EQ(loom_.sheds, shafts_of({0, 1, 2, 3, 0, 1}));
  EXPECT_EQ(state_.woven, 5);
}

TEST_P(Avl, AStepByHandAndAJumpChangeTheNextShed) {
  weave_the_first_two();
  take(step_by_hand(setup(), state_, false));
  weave();
  EXPECT_EQ(state_.next_pick, 0);
  take(sent_again(setup(), moved_to_pick(state_, {}, 4, 3)));
  weave();
  EXPECT_EQ(state_.next_pick, 3);
  EXPECT_EQ(loom_.sheds, shafts_of({0, 3}));
}

TEST_P(Avl, ABrokenLineLosesNoPick) {
  weave_the_first_two();
  reader_ = LoomReader(GetParam());
  take(on_connected(setup(), state_));
  weave();
  EXPECT_EQ(loom_.sheds, shafts_of(std::vector<int>{2}));
  EXPECT_EQ(state_.next_pick, 2);
}

TEST_P(Avl, ARepeatedReportChangesNothing) {
  take(on_connected(setup(), state_));
  said(loom_.open_shed());
  weave();
  const std::string open = GetParam() == Protocol::kAvl4 ? "<down>" : "\x62\x03";
  said(open);
  said(open);
  loom_.sheds.clear();
  weave();
  EXPECT_EQ(loom_.sheds, shafts_of(std::vector<int>{1}));
}

INSTANTIATE_TEST_SUITE_P(CompuDobby, Avl, testing::Values(Protocol::kAvl3, Protocol::kAvl4));

TEST(AvlProtocol, WhatIsSentAndHeard) {
  EXPECT_EQ(raise_command(Protocol::kAvl3, 0x3), std::string("\x13\x20\x30\x40\x50\x60\x70\x80\x07"));
  EXPECT_EQ(raise_command(Protocol::kAvl4, 0x80000005), "clear\rpick 1,3,32\r");
  EXPECT_EQ(raise_command(Protocol::kAvl4, 0), "clear\r");
  EXPECT_EQ(direction_command(Protocol::kAvl3, false), "");
  LoomReader reader(Protocol::kAvl4);
  const auto negative = reader.parse("<Compu-Dobby IV, 08H, Neg Dobby, HW A.1>");
  ASSERT_EQ(negative.size(), 1U);
  EXPECT_EQ(negative[0].kind, LoomReport::kNegativeDobby);
  EXPECT_EQ(reader.parse("<hello>").at(0).text, "hello");
  EXPECT_EQ(LoomReader(Protocol::kAvl3).parse(std::string("\x05\x03")).at(0).kind, LoomReport::kUnknown);
}

}  // namespace
}  // namespace weftlight::loom
