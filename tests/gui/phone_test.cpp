// The page for a phone at the loom: served by the window on request, paired by the code that it shows, and a step on
// the phone is a step at the loom.

#include <gtest/gtest.h>

#include <string>

#include "../unit/page_caller.h"
#include "on_display.h"

namespace weftlight::gui {
namespace {

/// What stands between two texts; empty if they are not there.
std::string between(const std::string& all, const std::string& before, const std::string& after) {
  const size_t from = all.find(before);
  if (from == std::string::npos) return {};
  const size_t begin = from + before.size();
  return all.substr(begin, all.find(after, begin) - begin);
}

using PhoneTest = OnDisplay;

TEST_F(PhoneTest, AStepOnThePhoneIsAStepAtTheLoom) {
  Window w(display_, folder_, draft_);
  ASSERT_TRUE(comes_true([&] { return w.is_ready(); }));
  display_.key("F9");
  ASSERT_TRUE(comes_true([&] { return w.has("loom.page") && w.has("loom.pick:1"); }));
  EXPECT_TRUE(w.name_after("loom.page_url:").empty()) << "it is served without being asked for";
  display_.click(w.middle_of("loom.page"));
  ASSERT_TRUE(comes_true([&] { return !w.name_after("loom.page_code:").empty(); })) << "no code is shown";
  const std::string host = between(w.name_after("loom.page_url:") + "/", "http://", "/");
  ASSERT_FALSE(host.empty());
  Browser phone(host);
  const std::string stranger = phone.get("/");
  EXPECT_NE(stranger.find("name=\"code\""), std::string::npos) << "a stranger is asked for the code\n" << stranger;
  EXPECT_EQ(stranger.find("id=\"number\""), std::string::npos) << "a stranger sees the pick";

  const std::string code = w.name_after("loom.page_code:");
  const std::string paired = phone.post("/pair", "code=" + code);
  ASSERT_TRUE(phone.keep_cookie(paired)) << paired;
  EXPECT_TRUE(comes_true([&] { return w.name_after("loom.page_code:") != code; })) << "a code pairs one device";

  const auto number = [](const std::string& page) { return between(page, "id=\"number\">", "<"); };
  const std::string page = phone.get("/"), at = between(page, "name=\"at\" value=\"", "\"");
  ASSERT_EQ(number(page), "1") << page;
  phone.post("/next", "at=" + at);
  EXPECT_TRUE(comes_true([&] { return w.has("loom.pick:2"); })) << "the loom did not go on";
  EXPECT_EQ(number(phone.get("/")), "2");
  phone.post("/next", "at=" + at);
  EXPECT_EQ(number(phone.get("/")), "2") << "a step that a phone sends twice is made twice";

  display_.click(w.middle_of("loom.page_off"));
  ASSERT_TRUE(comes_true([&] { return w.name_after("loom.page_url:").empty(); }));
  EXPECT_EQ(phone.get("/"), "") << "it is still served";
}

}  // namespace
}  // namespace weftlight::gui
