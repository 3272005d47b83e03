// Weaving at a mock loom: messages alone, then TCP and serial connections that break.

#include <gtest/gtest.h>
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>

#include "../hand_drafts.h"
#include "../loom_port.h"
#include "../loom_terminal.h"
#include "../scratch.h"
#include "loom/open_line.h"
#include "loom/weaving.h"

namespace weftlight::loom {

using design::treadled;
using draft::BitMatrix, draft::Draft, draft::blank_draft, draft::lifts;

namespace {

Draft four_picks() {
  return treadled({"1000", "0100", "0010", "0001"}, {"1100", "0110", "0011", "1001"}, {"1000", "0100", "0010", "0001"});
}

TEST(Protocol, CommandsOfEachProtocol) {
  EXPECT_EQ(raise_command(Protocol::kPlain, 0x1f), "C0000001f\n");
  EXPECT_EQ(raise_command(Protocol::kSeguin, 0x80000000u), "=C80000000\n");
  EXPECT_EQ(raise_command(Protocol::kToikaEs, 0x01020304), std::string("\x01\x02\x03\x04"));
  EXPECT_EQ(direction_command(Protocol::kPlain, true), "U0\n");
  EXPECT_EQ(direction_command(Protocol::kSeguin, false), "=U1\n");
}

TEST(Protocol, ReportsInPiecesAndUnknownMessages) {
  LoomReader reader;
  EXPECT_TRUE(reader.parse("c0000").empty());
  auto reports = reader.parse("000f\r\np\nu1\nm1\nhello\n\n");
  ASSERT_EQ(reports.size(), 5u);
  EXPECT_EQ(reports[0].kind, LoomReport::kShaftsRaised);
  EXPECT_EQ(reports[0].shafts, 15u);
  EXPECT_EQ(reports[1].kind, LoomReport::kPickWanted);
  EXPECT_EQ(reports[2].kind, LoomReport::kDirection);
  EXPECT_FALSE(reports[2].on);
  EXPECT_TRUE(reports[3].on);
  EXPECT_EQ(reports[4].kind, LoomReport::kUnknown);
  EXPECT_EQ(reports[4].text, "hello");
  reports = reader.parse(std::string(5000, 'x'));
  ASSERT_EQ(reports.size(), 1u) << "a line without end is told while it comes, once";
  EXPECT_EQ(reports[0].kind, LoomReport::kUnknown);
  EXPECT_EQ(reports[0].text, std::string(LoomReader::kMaxLineBytes, 'x'));
  EXPECT_TRUE(reader.parse("\n").empty());
  EXPECT_EQ(reader.parse("\x1b[2J\xff\n").at(0).text, "?[2J?") << "it is shown as text";
  EXPECT_EQ(reader.parse("p\n").size(), 1u);
}

TEST(Protocol, ASinkingShedRaisesTheOthers) {
  Draft d = four_picks();
  EXPECT_EQ(raised_shafts(d, lifts(d), 0), 0b0011u);
  d.rising = false;
  EXPECT_EQ(raised_shafts(d, lifts(d), 0), 0b1100u);
  EXPECT_FALSE(raised_shafts(d, lifts(d), 4));
  EXPECT_FALSE(raised_shafts(blank_draft(2, 2, 33, 2), BitMatrix(2, 33), 0)) << "the protocol has room for 32 shafts";
}

/// A loom that obeys and confirms.
struct MockLoom {
  std::vector<uint32_t> raised;
  bool weaving = true;
  std::string hear(std::string_view words) {
    std::string said;
    while (!words.empty()) {
      const std::string line(words.substr(0, words.find('\n')));
      words.remove_prefix(std::min(line.size() + 1, words.size()));
      if (line[0] == 'U') weaving = line[1] == '0';
      if (line[0] != 'C') continue;
      raised.push_back(static_cast<uint32_t>(std::stoul(line.substr(1), nullptr, 16)));
      said.append("c").append(line, 1).append("\n");
    }
    return said;
  }
};

/// The program's side: handles the received bytes and collects what it sends.
void hear(const WeavingSetup& w, LoomReader& reader, WeavingState& state, std::string_view words, std::string& send) {
  for (const LoomReport& report : reader.parse(words)) {
    const LoomReply a = reply_to(w, state, report);
    state = a.state;
    send += a.send;
    EXPECT_EQ(a.remark, "");
  }
}

TEST(Weaving, PicksAreRaisedInOrderAndUnwovenBackwards) {
  const Draft d = four_picks();
  const BitMatrix lift = lifts(d);
  const WeavingSetup w{d, lift, {}};
  MockLoom loom;
  LoomReader reader;
  WeavingState state;
  std::string said = "p\n";
  for (int i = 0; i < 6; ++i) {
    std::string send;
    hear(w, reader, state, said, send);
    said = loom.hear(send) + "p\n";
  }
  EXPECT_EQ(loom.raised, (std::vector<uint32_t>{3, 6, 12, 9, 3, 6}));
  EXPECT_EQ(state.next_pick, 1);
  EXPECT_EQ(state.woven, 5);
  // The loom now unweaves: the next pick is the one before.
  std::string send;
  hear(w, reader, state, "u1\np\n", send);
  EXPECT_EQ(send, "C00000003\n");
  EXPECT_EQ(state.woven, 4);
}

TEST(Weaving, ARangeIsRepeated) {
  const Draft d = four_picks();
  const BitMatrix lift = lifts(d);
  const WeavingSetup w{d, lift, {1, 3}};
  WeavingState state = moved_to_pick({}, w.range, 4, 0);
  EXPECT_EQ(state.next_pick, 1);
  std::vector<int> picks;
  for (int i = 0; i < 5; ++i) {
    const LoomReply a = step_by_hand(w, state, true);
    state = a.state;
    picks.push_back(state.next_pick);
  }
  EXPECT_EQ(picks, (std::vector<int>{1, 2, 1, 2, 1}));
}

TEST(Weaving, SaysWhenTheLoomRaisedOtherShafts) {
  const Draft d = four_picks();
  const BitMatrix lift = lifts(d);
  const WeavingSetup w{d, lift, {}};
  const WeavingState up = reply_to(w, {}, {LoomReport::kPickWanted}).state;
  EXPECT_FALSE(reply_to(w, up, {LoomReport::kShaftsRaised, 1}).remark.empty());
  EXPECT_TRUE(reply_to(w, up, {LoomReport::kShaftsRaised, 3}).remark.empty());
  EXPECT_FALSE(reply_to(w, up, {LoomReport::kUnknown, 0, false, "?"}).remark.empty());
}

constexpr std::chrono::milliseconds kPatience{5000}, kShort{1000};

std::string read_some(int socket) {
  pollfd waits{socket, POLLIN, 0};
  if (::poll(&waits, 1, 5000) <= 0) return {};
  char buffer[256];
  const ssize_t got = ::read(socket, buffer, sizeof buffer);
  return got > 0 ? std::string(buffer, static_cast<size_t>(got)) : std::string();
}

void write_all(int socket, std::string_view words) {
  ASSERT_EQ(::write(socket, words.data(), words.size()), static_cast<ssize_t>(words.size()));
}

TEST(LoomLine, ABrokenConnectionLosesNoPick) {
  const Draft d = four_picks();
  const BitMatrix lift = lifts(d);
  const WeavingSetup w{d, lift, {}};
  LoomPort port;
  const std::string address = port.address();
  WeavingState state;
  std::vector<uint32_t> raised;
  platform::LineConnector connector;
  for (int connection = 0; connection < 3; ++connection) {
    const auto opened = open_line(connector, address);
    ASSERT_TRUE(opened) << problem_of(opened);
    platform::Line& line = **opened;
    const int loom = port.accepted();
    MockLoom mock;
    LoomReader reader;
    ASSERT_TRUE(line.send(on_connected(w, state).send));
    mock.hear(read_some(loom));
    if (connection > 0) {
      // Only the pick that was not confirmed is raised again.
      ASSERT_EQ(mock.raised, (std::vector<uint32_t>{raised.back()}));
    }
    for (int pick = 0; pick < 3; ++pick) {
      write_all(loom, "p\n");
      std::string send;
      hear(w, reader, state, line.receive(kPatience), send);
      ASSERT_TRUE(line.send(send));
      mock.raised.clear();
      mock.hear(read_some(loom));
      ASSERT_EQ(mock.raised.size(), 1u);
      raised.push_back(mock.raised[0]);
    }
    ::close(loom);
    line.receive(kShort);
    EXPECT_TRUE(line.broken());
  }
  EXPECT_EQ(raised, (std::vector<uint32_t>{3, 6, 12, 9, 3, 6, 12, 9, 3})) << "each pick once";
}

TEST(LoomLine, AnUnpluggedSerialLineLosesNoPick) {
  const Draft d = four_picks();
  const BitMatrix lift = lifts(d);
  const WeavingSetup w{d, lift, {}};
  const Scratch scratch("serial");
  LoomTerminal loom(scratch / "loom");
  if (!loom.is_there()) GTEST_SKIP() << "this machine gives no pseudo-terminals";
  WeavingState state;
  std::string last;
  std::vector<std::string> raised;
  platform::LineConnector connector;
  for (int connection = 0; connection < 3; ++connection) {
    if (connection > 0) loom.plug_in();
    const auto opened = open_line(connector, loom.address() + ":19200");
    ASSERT_TRUE(opened) << problem_of(opened);
    platform::Line& line = **opened;
    LoomReader reader;
    ASSERT_TRUE(line.send(on_connected(w, state).send));
    EXPECT_EQ(loom.heard(), "U0") << "no echo, nothing that a terminal adds";
    if (connection > 0) {
      EXPECT_EQ(loom.heard(), last) << "the pick that was not confirmed, again";
    }
    for (int pick = 0; pick < 3; ++pick) {
      loom.say("p\n");
      std::string send;
      hear(w, reader, state, line.receive(kPatience), send);
      ASSERT_TRUE(line.send(send));
      last = loom.heard();
      raised.push_back(last);
      loom.say(std::string("c").append(last, 1).append("\n"));
      hear(w, reader, state, line.receive(kPatience), send);
    }
    loom.pull_out();
    line.receive(kShort);
    EXPECT_TRUE(line.broken());
    EXPECT_FALSE(line.send("C00000001\n"));
  }
  EXPECT_EQ(raised, (std::vector<std::string>{"C00000003", "C00000006", "C0000000c", "C00000009", "C00000003",
                                              "C00000006", "C0000000c", "C00000009", "C00000003"}))
      << "each pick once";
}

std::string why_not(const std::string& address) {
  platform::LineConnector connector;
  return problem_of(open_line(connector, address));
}

TEST(LoomLine, AFileIsNotASerialPort) {
  const Scratch scratch("serial");
  std::ofstream(scratch / "file") << "p\n";
  EXPECT_NE(why_not("serial:" + (scratch / "file")).find("no such serial port"), std::string::npos);
  LoomTerminal loom(scratch / "loom");
  if (!loom.is_there()) GTEST_SKIP() << "this machine gives no pseudo-terminals";
  EXPECT_NE(why_not(loom.address() + ":1234").find("1234 baud"), std::string::npos);
}

TEST(LoomLine, SaysWhyItCannotBeOpened) {
  EXPECT_NE(why_not("loom").find("tcp:HOST:PORT"), std::string::npos);
  EXPECT_NE(why_not("serial:/dev/there-is-no-such-loom").find("no such serial port"), std::string::npos);
  std::string closed;
  {
    const LoomPort port;
    ASSERT_GT(port.number(), 0);
    closed = port.address();
  }
  EXPECT_NE(why_not(closed).find("Connection refused"), std::string::npos);
}

TEST(LoomLine, SaysThatThereIsNoSuchHost) {
  platform::LineConnector connector([](const std::string&, const std::string&) { return platform::HostFound{}; });
  EXPECT_EQ(problem_of(open_line(connector, "tcp:loom.invalid:7388")), "loom.invalid: there is no such host");
}

}  // namespace
}  // namespace weftlight::loom
