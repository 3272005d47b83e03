// The page for a phone, from the browser to the weaver's steps and back.

#include "session/loom/phone_link.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <thread>

#include "../page_caller.h"

namespace weftlight::session {
namespace {

/// Of the page's script.
Browser script_of(const PhoneLink& link) {
  const std::string url = link.status().url;  // http://HOST/
  Browser browser(url.substr(7, url.size() - 8));
  browser.ask_for_json();
  return browser;
}

PhoneShown pick(int number) {
  PhoneShown shown;
  shown.heading = "Pick";
  shown.number = std::to_string(number);
  return shown;
}

TEST(PhoneLinkTest, AStepOfThePhoneIsTheWeaversAndComesBack) {
  std::atomic<int> woken = 0;
  PhoneLink link([&] { ++woken; });
  EXPECT_FALSE(link.status().open) << "off unless asked for";
  ASSERT_TRUE(link.open("127.0.0.1"));
  link.show(pick(1));
  Browser phone = script_of(link);
  EXPECT_EQ(phone.get("/state").find("Pick"), std::string::npos) << "not paired";
  phone.keep_cookie(phone.post("/pair", "code=" + link.status().code));
  EXPECT_EQ(link.status().paired, 1u);
  EXPECT_GE(woken, 1) << "the window shows that somebody was paired";
  EXPECT_NE(phone.get("/state").find("\"number\":\"1\""), std::string::npos);
  std::string answer;
  std::thread asks([&] { answer = phone.post("/next", "at=2"); });
  std::vector<PhoneStep> steps;
  for (int i = 0; i < 3000 && steps.empty(); ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
    steps = link.take_steps();
  }
  link.show(pick(2));
  asks.join();
  ASSERT_EQ(steps, std::vector<PhoneStep>{PhoneStep::kNext});
  EXPECT_NE(answer.find("\"number\":\"2\""), std::string::npos) << answer;
  EXPECT_NE(phone.post("/next", "at=2").find("\"number\":\"2\""), std::string::npos) << "from an old page";
  EXPECT_TRUE(link.take_steps().empty());
  link.close();
  EXPECT_FALSE(link.status().open);
  EXPECT_EQ(phone.get("/state"), "");
}

TEST(PhoneLinkTest, WrongCodesCloseThePairingAndTheWindowTells) {
  PhoneLink link([] {});
  ASSERT_TRUE(link.open("127.0.0.1"));
  const Browser stranger = script_of(link);
  for (int i = 0; i < loom::PhonePage::kMaxTries; ++i) stranger.post("/pair", "code=x");
  EXPECT_TRUE(link.status().code.empty());
  link.renew_code();
  EXPECT_EQ(link.status().code.size(), 6u);
  EXPECT_FALSE(link.open("192.0.2.1")) << "no address of this machine";
  EXPECT_FALSE(link.status().open);
}

}  // namespace
}  // namespace weftlight::session
