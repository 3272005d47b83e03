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

using wif::Severity;

std::string all_of(const Messages& messages) {
  std::string all;
  for (const Diagnostic& d : messages.remarks()) all += d.text + "; ";
  return all;
}

TEST(MessagesTest, TellEachFileThatCouldNotBeOpened) {
  Messages messages([] { return 0.0; });
  messages.report({{Severity::kError, 3, "no threading", {}}}, "drafts/a.wif");
  messages.follow({{Severity::kWarning, 0, "c has no colours", {}}});  // the next of the files is shown
  messages.report({{Severity::kError, 0, "/x/b.wif: cannot be read", {}}}, "/x/b.wif");
  EXPECT_EQ(messages.shown().text, "a.wif, b.wif could not be opened");
  EXPECT_TRUE(messages.shown().refusal);
  messages.follow({{Severity::kWarning, 0, "d has no colours", {}}});
  EXPECT_EQ(all_of(messages), "a.wif: no threading; /x/b.wif: cannot be read; d has no colours; ");
  EXPECT_TRUE(messages.close_remarks()) << "they are shown";
  messages.follow({});
  EXPECT_EQ(all_of(messages), "") << "they were read";
  messages.report({{Severity::kError, 0, "no threading", {}}}, "e.wif");
  EXPECT_EQ(messages.shown().text, "e.wif could not be opened");
}

}  // namespace
}  // namespace weftlight::app
