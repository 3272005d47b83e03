// Pages for browsers in the local network, and what hostile peers do to them: garbage, a line without end, a byte now
// and then, connections without number.

#include "platform/page_server.h"

#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <mutex>
#include <vector>

#include "../page_caller.h"
#include "platform/own_addresses.h"
#include "platform/random_bytes.h"

namespace weftlight::platform {
namespace {

using std::chrono::milliseconds;

constexpr const char* kGet = "GET /x HTTP/1.1\r\nHost: a\r\n\r\n";

std::unique_ptr<PageServer> served(PageServer::Handler handler, PageLimits limits = {}) {
  auto server = PageServer::open(
      "127.0.0.1", 0, std::move(handler), [] {}, limits);
  return server ? std::move(*server) : nullptr;
}

void answer_hello(const PageRequest& request, const PageServer::Reply& reply) {
  reply({200, "text/plain", "hello " + request.target + " from " + request.peer, {{"X-More", "1"}}});
}

TEST(PageServerTest, AnswersARequestAndHangsUp) {
  const auto server = served(answer_hello);
  ASSERT_TRUE(server);
  EXPECT_TRUE(server->host().starts_with("127.0.0.1:"));
  const Caller caller(server->host());
  ASSERT_TRUE(caller.say(kGet));
  EXPECT_EQ(
      caller.heard(),
      "HTTP/1.1 200 OK\r\nConnection: close\r\nContent-Length: 23\r\nContent-Type: text/plain\r\nX-More: 1\r\n\r\n"
      "hello /x from 127.0.0.1");
  EXPECT_FALSE(PageServer::open("192.0.2.1", 0, answer_hello)) << "no address of this machine";
  EXPECT_FALSE(PageServer::open("anywhere", 0, answer_hello));
}

TEST(PageServerTest, AnAnswerMayComeLaterOrNever) {
  std::mutex mutex;
  std::vector<PageServer::Reply> replies;
  auto server = served(
      [&](const PageRequest&, PageServer::Reply reply) {
        const std::lock_guard lock(mutex);
        replies.push_back(std::move(reply));
      },
      {.held = milliseconds(50)});
  ASSERT_TRUE(server);
  const Caller caller(server->host());
  ASSERT_TRUE(caller.say(kGet));
  EXPECT_TRUE(caller.heard().starts_with("HTTP/1.1 204 ")) << "nothing came in time";
  server.reset();
  for (const auto& reply : replies) reply({200});
}

TEST(PageServerTest, WhatIsNoRequestIsRefusedAndCounted) {
  const auto server = served(answer_hello);
  ASSERT_TRUE(server);
  uint64_t count = 0;
  const std::vector<std::string> none{std::string("\x16\x03\x01\x02\0\x01garbage\xff", 14), "\r\n\r\n \r\n",
                                      "GET /" + std::string(40000, 'a'),
                                      "POST / HTTP/1.1\r\nHost: a\r\nContent-Length: 99999999999\r\n\r\n"};
  for (const std::string& words : none) {
    const Caller caller(server->host());
    caller.say(words);
    EXPECT_TRUE(caller.heard().starts_with("HTTP/1.1 4")) << words.substr(0, 20);
    EXPECT_EQ(server->refusals().requests, ++count);
  }
  EXPECT_EQ(server->refusals().peer, "127.0.0.1");
  const Caller caller(server->host());
  ASSERT_TRUE(caller.say(kGet));
  EXPECT_TRUE(caller.heard().starts_with("HTTP/1.1 200 ")) << "the next is served";
}

TEST(PageServerTest, ALineWithoutEndIsNotHoarded) {
  const auto server = served(answer_hello);
  ASSERT_TRUE(server);
  const Caller caller(server->host());
  const std::string part(65536, 'a');
  size_t said = 0;
  while (said < (size_t{64} << 20) && caller.say(part)) said += part.size();
  EXPECT_LT(said, size_t{64} << 20) << "all was heard";
}

TEST(PageServerTest, OneThatSaysAByteNowAndThenLosesItsPlace) {
  const auto server = served(answer_hello, {.request = milliseconds(100)});
  ASSERT_TRUE(server);
  const Caller slow(server->host());
  ASSERT_TRUE(slow.say("GET"));
  EXPECT_EQ(slow.heard(), "") << "it was hung up on";
  EXPECT_EQ(server->refusals().connections, 1u);
}

TEST(PageServerTest, AThousandConnectionsTakeTheRoomOfAFew) {
  std::atomic<int> told = 0;
  auto opened = PageServer::open("127.0.0.1", 0, answer_hello, [&] { ++told; },
                                 {.connections = 6, .of_one_peer = 4, .request = std::chrono::minutes(10)});
  ASSERT_TRUE(opened);
  const auto server = std::move(*opened);
  std::vector<Caller> crowd;
  int turned_away = 0;
  for (int i = 0; i < 1000; ++i) {
    Caller caller(server->host());
    if (crowd.size() < 4) {
      crowd.push_back(std::move(caller));
      continue;
    }
    caller.say(kGet);
    turned_away += caller.heard().empty() ? 1 : 0;
  }
  EXPECT_EQ(turned_away, 996);
  EXPECT_EQ(server->refusals().connections, 996u);
  EXPECT_GE(told, 1);
  EXPECT_LE(told, 60) << "once in a second";
  // Those that were first are served; when they have gone there is room again.
  ASSERT_TRUE(crowd[0].say(kGet));
  EXPECT_TRUE(crowd[0].heard().starts_with("HTTP/1.1 200 "));
  crowd.clear();
  bool served_again = false;
  for (int i = 0; i < 3000 && !served_again; ++i) {
    const Caller caller(server->host());
    caller.say(kGet);
    served_again = caller.heard().starts_with("HTTP/1.1 200 ");
  }
  EXPECT_TRUE(served_again);
}

TEST(PageServerTest, WhatAHandlerThrowsEndsOneConnection) {
  std::atomic<bool> first = true;
  const auto server = served(
      [&](const PageRequest& request, const PageServer::Reply& reply) {
        if (first.exchange(false)) throw std::bad_alloc();
        answer_hello(request, reply);
      },
      {.held = milliseconds(50)});
  ASSERT_TRUE(server);
  const Caller unlucky(server->host());
  unlucky.say(kGet);
  unlucky.heard();
  const Caller caller(server->host());
  caller.say(kGet);
  EXPECT_TRUE(caller.heard().starts_with("HTTP/1.1 200 "));
}

TEST(OwnAddresses, BeginWithThisMachine) {
  const auto all = own_addresses();
  ASSERT_FALSE(all.empty());
  EXPECT_EQ(all[0].address, "127.0.0.1");
  EXPECT_TRUE(all[0].this_machine_only);
  for (const OwnAddress& one : all) EXPECT_TRUE(PageServer::open(one.address, 0, answer_hello)) << one.address;
}

TEST(RandomBytes, DifferEachTime) {
  std::array<uint8_t, 32> a{}, b{};
  ASSERT_TRUE(fill_random(a));
  ASSERT_TRUE(fill_random(b));
  EXPECT_NE(a, b);
}

}  // namespace
}  // namespace weftlight::platform
