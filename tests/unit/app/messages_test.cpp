// A message stands until it was read and something else is done.

#include "app/messages.h"

#include <gtest/gtest.h>

namespace weftlight::app {
namespace {

TEST(MessagesTest, StandsUntilTheActionAfterItWasRead) {
  double now_s = 100;
  Messages messages([&now_s] { return now_s; });
  messages.refuse("the drawdown is locked");
  EXPECT_TRUE(messages.shown().refusal);
  now_s += 3.9;
  messages.begin_action();
  EXPECT_EQ(messages.shown().text, "the drawdown is locked") << "nobody can have read it";
  now_s += 3600;
  EXPECT_EQ(messages.shown().text, "the drawdown is locked") << "it went by itself";
  messages.begin_action();
  EXPECT_EQ(messages.shown().text, "");
  messages.say("Saved a.wif");
  messages.begin_action();
  EXPECT_EQ(messages.shown().text, "Saved a.wif") << "the time counts from the message on";
}

}  // namespace
}  // namespace weftlight::app
