// Settings survive any file and any path.

#include <gtest/gtest.h>

#include "../memory_taken.h"
#include "base/utf8.h"
#include "print/print_options.h"
#include "session/editing/analysis_view.h"
#include "session/files/user_files.h"

namespace weftlight::session {

using base::is_utf8;

namespace {

TEST(Settings, APathThatIsNotUtf8IsSavedWithoutLoss) {
  Settings s;
  s.dark = true;
  s.width = 1234;
  s.recent = {"/drafts/caf\xE9.wif", "/drafts/caf\xC3\xA9.wif"};
  const std::string text = settings_text(s);
  EXPECT_TRUE(is_utf8(text));
  const Settings back = settings_from(text);
  EXPECT_EQ(back.recent, s.recent);
  EXPECT_TRUE(back.dark);
  EXPECT_EQ(back.width, 1234);
}

TEST(Settings, LoomAddressAndHeavyLinesAreSaved) {
  Settings s;
  s.loom_address = "tcp:localhost:8000";
  s.heavy_lines = 8;
  const Settings back = settings_from(settings_text(s));
  EXPECT_EQ(back.loom_address, s.loom_address);
  EXPECT_EQ(back.heavy_lines, 8);
  EXPECT_EQ(settings_from("{\"heavy_lines\": -3, \"loom\": 4}").heavy_lines, 0);
}

TEST(Settings, OrientationAndStyleAreSaved) {
  Settings s;
  s.end1_right = s.minimap = s.cloth = false;
  s.pick1_bottom = true;
  s.threading_below = s.tiled = s.show_repeat = true;
  const Settings back = settings_from(settings_text(s));
  EXPECT_FALSE(back.end1_right || back.minimap || back.cloth);
  EXPECT_TRUE(back.pick1_bottom);
  EXPECT_TRUE(back.threading_below && back.tiled && back.show_repeat);
  EXPECT_TRUE(settings_from("{}").minimap);
}

TEST(Settings, TheTimeLimitOfAPictureIsClamped) {
  Settings s;
  s.by_time = true;
  s.picture_ms = 250;
  const Settings back = settings_from(settings_text(s));
  EXPECT_TRUE(back.by_time);
  EXPECT_EQ(back.picture_ms, 250);
  EXPECT_EQ(settings_from("{\"picture_ms\": 0}").picture_ms, Settings{}.picture_ms);
}

TEST(Settings, YarnPricesAndWasteAreSaved) {
  Settings s;
  s.loom_waste_cm = 90, s.spare_yarn = 0, s.imperial = true, s.language = "pt_BR";
  s.yarn_prices = {{"Linen 16/2", 38.5f}, {"Silk \xFF", 100}};
  const Settings back = settings_from(settings_text(s));
  EXPECT_EQ(back.loom_waste_cm, 90);
  EXPECT_TRUE(back.imperial);
  EXPECT_EQ(back.language, "pt_BR");
  EXPECT_EQ(settings_from(R"({"language": "../pt_BR"})").language, "") << "no name of a language";
  EXPECT_TRUE(settings_from(R"({"per_inch": true})").imperial) << "of an earlier version";
  EXPECT_EQ(back.spare_yarn, 0);
  EXPECT_EQ(back.yarn_prices, (std::map<std::string, float>{{"Linen 16/2", 38.5f}})) << "names that are text";
  const Settings odd = settings_from(R"({"loom_waste_cm": -4, "spare_yarn": 7, "yarn_prices": {"A": -1, "B": "x"}})");
  EXPECT_EQ(odd.loom_waste_cm, Settings{}.loom_waste_cm);
  EXPECT_EQ(odd.spare_yarn, Settings{}.spare_yarn);
  EXPECT_TRUE(odd.yarn_prices.empty());
}

TEST(Settings, ANewDraftIsOnTheLoomOfTheLastPlan) {
  Settings s;
  design::ClothPlan plan;
  plan.width_mm = 500, plan.loom_waste_mm = 750, plan.spare = 0.1f;
  plan.purchases = {{"Linen", 0, 0, 40}, {"Silk", 100, 0, 25}};
  remember_plan(s, plan);
  EXPECT_EQ(s.yarn_prices, (std::map<std::string, float>{{"Linen", 40.0f}})) << "prices of a kilogram";
  const design::Design made = with_usual_plan({}, s);
  EXPECT_EQ(made.plan.loom_waste_mm, 750);
  EXPECT_EQ(made.plan.spare, 0.1f);
  EXPECT_EQ(made.plan.width_mm, 0) << "another cloth";
}

TEST(Settings, ShortcutsAreSaved) {
  Settings s;
  s.keys = {{"save", "Ctrl+U"}, {"quit", ""}};
  EXPECT_EQ(settings_from(settings_text(s)).keys, s.keys);
  EXPECT_TRUE(settings_from("{\"keys\": [\"save\"]}").keys.empty());
  EXPECT_EQ(settings_from("{\"keys\": {\"save\": 3, \"open\": \"F3\"}}").keys.size(), 1u);
}

TEST(Settings, AShortcutKeepsItsActionUnderTheEarlierId) {
  using Keys = std::map<std::string, std::string>;
  EXPECT_EQ(settings_from(R"({"keys": {"nearest": "F7"}})").keys, (Keys{{"closest_weave", "F7"}}));
  EXPECT_EQ(settings_from(R"({"keys": {"closest_weave": "F8", "nearest": "F7"}})").keys,
            (Keys{{"closest_weave", "F8"}}));
}

TEST(Settings, InvalidValuesAreAsIfMissing) {
  for (const char* text : {"", "[]", "{", "{\"width\": \"wide\", \"recent\": 3, \"dark\": 1}", "\xFF\xFE"}) {
    const Settings s = settings_from(text);
    EXPECT_EQ(s.width, Settings{}.width) << text;
    EXPECT_TRUE(s.recent.empty()) << text;
  }
  const Settings far = settings_from("{\"width\": 1e300, \"height\": -1e300, \"split\": 1e300}");
  EXPECT_EQ(far.width, 16384);
  EXPECT_EQ(far.height, 240);
  EXPECT_EQ(far.split, 0);
}

TEST(Settings, BombsAreAsIfMissing) {
  const auto width = [](const std::string& text) {
    return [text] { return std::to_string(settings_from(text).width); };
  };
  const std::string usual = std::to_string(Settings{}.width), head = R"({"width": 999, "recent": )";
  expect_harmless(width(head + std::string(1'000'000, '[')), usual);
  std::string lists = head + "[";
  for (int i = 0; i < 200'000; ++i) lists += "[],";
  expect_harmless(width(lists + "0]}"), "999");
  std::string keys = R"({"width": 999, "keys": {)";
  for (int i = 0; i < 60'000; ++i) keys += '"' + std::to_string(i) + R"(":"a",)";
  expect_harmless(width(keys + R"("z":"a"}})"), "999");
  EXPECT_EQ(settings_from(keys + R"("z":"a"}})").keys.size(), 1000u);
}

TEST(Settings, TheWindowBeginsWithTheDefaultsOfTheCommands) {
  EXPECT_EQ(Settings{}.heavy_lines, print::PrintOptions{}.heavy_lines);
  EXPECT_EQ(AnalysisView{}.float_limit, analysis::kFloatLimit);
}

}  // namespace
}  // namespace weftlight::session
