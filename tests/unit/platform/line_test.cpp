// Lines that hang: every wait ends when it is no longer wanted.

#include "platform/line.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/socket.h>

#include <future>
#include <thread>

#include "../hanging_lookup.h"
#include "../loom_port.h"

namespace weftlight::platform {
namespace {

using namespace std::chrono_literals;
constexpr auto kForever = 60s;  // longer than any test may take

const TcpAddress kNamed{"loom.invalid", "7388"};

TcpAddress address_of(const LoomPort& port) { return {"127.0.0.1", std::to_string(port.number())}; }

TEST(Line, AHangingLookupIsStopped) {
  const HangingLookup names;
  std::stop_source stop;
  auto connected = std::async(std::launch::async, [&] {
    LineConnector connector(names.look_up());
    return connector.connect(kNamed, kForever, stop.get_token()).error().problem;
  });
  ASSERT_TRUE(names.is_asked());
  stop.request_stop();
  EXPECT_EQ(connected.get(), LineProblem::kStopped);
  EXPECT_FALSE(names.answered()) << "it waited for the name server";
  names.answer({});
}

TEST(Line, ALateAnswerServesTheNextAttempt) {
  const HangingLookup names;
  const LoomPort port;
  LineConnector connector(names.look_up());
  EXPECT_EQ(connector.connect(kNamed, 1ms).error().problem, LineProblem::kNoNameServer);
  EXPECT_EQ(connector.connect(kNamed, 1ms).error().problem, LineProblem::kNoNameServer);
  ASSERT_TRUE(names.is_asked());
  names.answer(HostEndpoints{{"127.0.0.1", static_cast<uint16_t>(port.number())}});
  EXPECT_TRUE(connector.connect(kNamed, kForever));
  EXPECT_EQ(names.asked(), 1) << "one question, however often it is tried";
}

TEST(Line, NamesThatHangDoNotPileUpThreads) {
  const HangingLookup names;
  LineConnector connector(names.look_up());
  for (int i = 0; i < 40; ++i)
    EXPECT_EQ(connector.connect(TcpAddress{"loom" + std::to_string(i), "1"}, 0ms).error().problem,
              LineProblem::kNoNameServer);
  names.answer({});
  EXPECT_LE(names.asked(), 8);
}

TEST(Line, AnUnknownHostIsNamed) {
  LineConnector connector([](const std::string&, const std::string&) { return HostFound{}; });
  EXPECT_EQ(connector.connect(kNamed, kForever).error().problem, LineProblem::kUnknownHost);
}

TEST(Line, AnAddressInNumbersNeedsNoNameServer) {
  const HangingLookup names;
  const LoomPort port;
  LineConnector connector(names.look_up());
  EXPECT_TRUE(connector.connect(address_of(port), kForever));
  EXPECT_EQ(names.asked(), 0);
}

TEST(Line, TheSystemKnowsThisMachine) {
  const LoomPort port;
  EXPECT_TRUE(LineConnector().connect(TcpAddress{"localhost", std::to_string(port.number())}, kForever));
}

/// A port of this machine that answers no one: its queue is full.
class DeafPort {
 public:
  DeafPort() {
    for (int i = 0; i < 4; ++i) {
      const int caller = ::socket(AF_INET, SOCK_STREAM | SOCK_NONBLOCK, 0);
      sockaddr_in at{};
      at.sin_family = AF_INET;
      at.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
      at.sin_port = htons(static_cast<uint16_t>(port_.number()));
      (void)::connect(caller, reinterpret_cast<sockaddr*>(&at), sizeof at);
      callers_.push_back(caller);
    }
  }
  ~DeafPort() {
    for (const int caller : callers_) ::close(caller);
  }
  DeafPort(const DeafPort&) = delete;
  DeafPort& operator=(const DeafPort&) = delete;
  TcpAddress address() const { return address_of(port_); }

 private:
  LoomPort port_;
  std::vector<int> callers_;
};

TEST(Line, AHostThatNeverAnswersIsGivenUp) {
  const DeafPort port;
  const LineConnected none = LineConnector().connect(port.address(), 20ms);
  ASSERT_FALSE(none);
  EXPECT_EQ(none.error().problem, LineProblem::kOther);
  EXPECT_FALSE(none.error().said.empty());
}

TEST(Line, AConnectionThatHangsIsStopped) {
  const DeafPort port;
  std::stop_source stop;
  auto connected = std::async(std::launch::async, [&] {
    return LineConnector().connect(port.address(), kForever, stop.get_token()).error().problem;
  });
  stop.request_stop();
  EXPECT_EQ(connected.get(), LineProblem::kStopped);
}

TEST(Line, ListeningIsStoppedAndTheLineStaysWhole) {
  const LoomPort port;
  std::stop_source stop;
  const LineConnected opened = LineConnector().connect(address_of(port), kForever, stop.get_token());
  ASSERT_TRUE(opened);
  const int loom = port.accepted();
  EXPECT_EQ((*opened)->receive(0ms), "");
  auto heard = std::async(std::launch::async, [&] { return (*opened)->receive(kForever); });
  stop.request_stop();
  EXPECT_EQ(heard.get(), "");
  EXPECT_FALSE((*opened)->broken());
  ::close(loom);
}

TEST(Line, WhatIsNotTakenBreaksTheLine) {
  const LoomPort port;
  const LineConnected opened = LineConnector().connect(address_of(port), kForever);
  ASSERT_TRUE(opened);
  const int loom = port.accepted();  // which never reads
  EXPECT_FALSE((*opened)->send(std::string(size_t{64} << 20, 'C')));
  EXPECT_TRUE((*opened)->broken());
  ::close(loom);
}

TEST(Line, AStartedProgramDoesNotHoldTheLine) {
  const LoomPort port;
  const int next = ::dup(0);  // the number that the socket gets, or one below it
  ::close(next);
  const LineConnected opened = LineConnector().connect(address_of(port), kForever);
  ASSERT_TRUE(opened);
  int inherited = 0;
  for (int fd = next; fd < next + 8; ++fd) {
    int type = 0;
    socklen_t size = sizeof type;
    if (::getsockopt(fd, SOL_SOCKET, SO_TYPE, &type, &size) == 0) inherited += (::fcntl(fd, F_GETFD) & FD_CLOEXEC) == 0;
  }
  EXPECT_EQ(inherited, 0);
}

TEST(Line, ALineOfAFileIsNoSerialPort) {
  LineConnector connector;
  EXPECT_EQ(connector.connect(SerialAddress{"/dev/null"}, 1ms).error().problem, LineProblem::kNoSuchPort);
  EXPECT_EQ(connector.connect(SerialAddress{"/dev"}, 1ms).error().problem, LineProblem::kNoSuchPort);
  EXPECT_EQ(connector.connect(SerialAddress{"/dev/there-is-none"}, 1ms).error().problem, LineProblem::kNoSuchPort);
}

}  // namespace
}  // namespace weftlight::platform
