// Every lighting preset has its file, and its sky is bright somewhere and nowhere negative.

#include "scene/light_rig.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "../memory_taken.h"
#include "design/lights.h"

namespace weftlight::scene {

using base::problem_of;
using design::LightingPreset, design::kLightingPresets, design::lighting_preset;

namespace {

TEST(LightRigs, EachSetupHasItsFile) {
  for (const LightingPreset& setup : kLightingPresets) {
    const base::Result<LightRig> read = load_light_rig(setup.id);
    ASSERT_EQ(problem_of(read), "");
    const LightRig& rig = *read;
    EXPECT_GT(std::min({rig.key.r, rig.key.g, rig.key.b}), 0.2f) << setup.id;
    EXPECT_GT(rig.sky[0].g, 0.1f) << setup.id;
    EXPECT_EQ(lighting_preset(setup.id).label, setup.label);
  }
  EXPECT_STREQ(lighting_preset("../../etc").id, "studio");
}

std::string problem_in(const std::string& text) { return problem_of(light_rig_from(text)); }

TEST(LightRigs, SayWhichLineIsWrong) {
  const auto rig = [](const std::string& key, const std::string& lamp) {
    return "{\n\"about\": {\"by\": {}},\n\"key\": " + key + ",\n\"lamps\": [\n{" + lamp + "},\n\n{" + lamp + "}]\n}\n";
  };
  const std::string lamp = R"("towards": [0, 1, 0], "sharpness": 1, "color": [1, 1, 1], "strength": )";
  EXPECT_EQ(problem_in(rig("[1, 1, 1]", lamp + "1")), "");
  EXPECT_EQ(problem_in(rig("[1, 1]", lamp + "1")), "3: key is not a list of three numbers");
  EXPECT_EQ(problem_in(rig("[1, -1, 1]", lamp + "1")), "3: key is -1; give 0 to 10000");
  EXPECT_EQ(problem_in(rig("[1, 1, 1]", lamp + "-2")), "5: lamp 1: strength is -2; give 0 to 10000");
  EXPECT_EQ(problem_in(rig("[1, 1, 1]", lamp + "\"much\"")), "5: lamp 1: strength is not a number");
  EXPECT_EQ(problem_in(rig("[1, 1, 1]", "\"towards\": [0, 0, 0]")), "5: lamp 1: towards is not a direction");
  EXPECT_EQ(problem_in(rig("[1, 1, 1]", lamp + "1e999")), "5: is invalid JSON from this point");
  EXPECT_EQ(problem_in("{\n\"lamps\": [\n"), "3: is invalid JSON from this point");
  EXPECT_EQ(problem_in("{\"key\": [1, 1, 1]}"), "1: lamps is missing");
  EXPECT_EQ(problem_in("[]"), "1: is not an object with key and lamps");
  std::string second = rig("[1, 1, 1]", lamp + "1");
  second.replace(second.rfind("\"strength\": 1"), 13, "\"strength\": nul");
  EXPECT_EQ(problem_in(second), "7: is invalid JSON from this point");
  second.replace(second.rfind("nul"), 3, "1e5");
  EXPECT_EQ(problem_in(second), "7: lamp 2: strength is 100000; give 0 to 10000");
}

TEST(LightRigs, BombsAreRefusedWithTheFigure) {
  const auto rig = [](const std::string& text) { return [text] { return problem_in(text); }; };
  const std::string head = R"({"key": [1, 1, 1], "lamps": [)";
  expect_harmless(rig(head + std::string(500'000, '[')), "nested deeper than 64");
  std::string lamps = head;
  for (int i = 0; i < 300'000; ++i) lamps += "{},";
  expect_harmless(rig(lamps + "{}]}"), "has 600008 values; at most 10000 are read");
}

}  // namespace
}  // namespace weftlight::scene
