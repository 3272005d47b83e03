// What files say of numbers that are the default: a user's file says all, so that its cloth stays in later versions; a
// shipped preset leaves them out.

#include <gtest/gtest.h>

#include "design/edits.h"
#include "design/fibre.h"
#include "design/yarn_fields.h"
#include "design/yarn_presets.h"
#include "lines.h"
#include "wif/wif.h"

namespace weftlight::wif {

using design::CrossSection, design::Design, design::Fibre, design::Yarn, design::kLobeFields, design::kPliesFacts,
    design::kYarnFields, design::with_cross_section, design::with_fibre, design::with_threading;

namespace {

/// The keys of a yarn, for the numbers that are always set.
std::vector<std::string> yarn_keys() {
  std::vector<std::string> keys{"Name", "Made Of", "Cross-section", "Twist", kPliesFacts.key, "Tint", "Metallic"};
  for (const auto& field : kYarnFields)
    if (!field.facts.optional) keys.emplace_back(field.facts.key);
  for (const auto& field : kLobeFields) keys.emplace_back(field.facts.key);
  return keys;
}

void expect_every_key(const std::string& bytes, size_t yarns) {
  for (size_t i = 1; i <= yarns; ++i)
    for (const std::string& key : yarn_keys())
      EXPECT_NE(bytes.find("\r\n" + std::to_string(i) + " " + key + "="), std::string::npos) << i << " " << key;
}

Design in_two_yarns() {
  Design design = opened(fixture("twill.wif")).design;
  Yarn wool;
  wool.name = "Wool";
  wool.diameter_mm = 0.7f;
  wool.lobes.fuzz = 0.3f;
  design.yarns.push_back(wool);
  design.draft.weft.yarn[1] = 1;
  design.scene.mesh = "skirt";
  design.scene.view_distance = 2;
  design.look.exposure_ev = 0.5f;
  return design;
}

TEST(Defaults, ANewFileStatesEveryNumberOfItsYarns) {
  const Design plain = opened(fixture("twill.wif")).design;
  ASSERT_EQ(plain.yarns, std::vector<Yarn>{Yarn{}});
  expect_every_key(write_new_wif(plain), 1);
  expect_every_key(write_new_wif(in_two_yarns()), 2);
  EXPECT_EQ(opened(write_new_wif(plain)).design, plain);
}

TEST(Defaults, AnEditKeepsThemStated) {
  const WifFile file = opened(write_new_wif(opened(fixture("twill.wif")).design));
  Design two = file.design;
  two.yarns.push_back(Yarn{});
  const WifFile with_two = opened(write_wif(file, two));
  expect_every_key(with_two.bytes, 2);
  EXPECT_EQ(write_wif(with_two, file.design), file.bytes) << "back to the default yarn alone";
}

TEST(Defaults, AFileOfAnotherProgramGetsNoYarns) {
  const WifFile file = opened(fixture("twill.wif"));
  EXPECT_EQ(write_wif(file, with_threading(file.design, 2, 0, true)).find("WEFTLIGHT"), std::string::npos);
}

TEST(Defaults, APresetLeavesThemOut) {
  const Design design = in_two_yarns();
  const std::string bytes = write_preset_wif(design);
  EXPECT_EQ(bytes.substr(bytes.find("[PRIVATE WEFTLIGHT YARNS]")),
            "[PRIVATE WEFTLIGHT YARNS]\r\nYarns=2\r\n1 Name=Cotton\r\n1 Made Of=Cotton\r\n1 Cross-section=Bean\r\n2 "
            "Name=Wool\r\n2 Made Of=Cotton\r\n2 "
            "Cross-section=Bean\r\n2 Diameter=0.7\r\n2 Fuzz=0.3\r\n\r\n"
            "[PRIVATE WEFTLIGHT WEFT YARNS]\r\n2=2\r\n\r\n"
            "[PRIVATE WEFTLIGHT LOOK]\r\nExposure=0.5\r\n\r\n"
            "[PRIVATE WEFTLIGHT SCENE]\r\nMesh=skirt\r\nView Distance=2\r\n");
  EXPECT_EQ(opened(bytes).design, design);
  expect_every_key(write_new_wif(opened(bytes).design), 2);
}

/// Without the lines that have this key.
std::string without(std::string bytes, const std::string& key) {
  for (size_t at = bytes.find(key + "="); at != std::string::npos; at = bytes.find(key + "=")) {
    const size_t begin = bytes.rfind('\n', at) + 1;
    bytes.erase(begin, bytes.find('\n', at) + 1 - begin);
  }
  return bytes;
}

TEST(Defaults, AYarnKeepsItsFibreWhateverItsOpticsAre) {
  Design design = opened(fixture("twill.wif")).design;
  Yarn linen = with_fibre(Yarn{}, Fibre::kLinen);
  linen.lobes = with_fibre(Yarn{}, Fibre::kSilk).lobes;
  design.yarns = {linen};
  EXPECT_EQ(opened(write_new_wif(design)).design.yarns, design.yarns);
  EXPECT_EQ(opened(write_preset_wif(design)).design.yarns, design.yarns);
}

TEST(Defaults, EveryReadyYarnComesBackFromAFile) {
  Design design = opened(fixture("twill.wif")).design;
  const auto all = design::ready_yarns();
  design.yarns.assign(all.begin(), all.end());
  EXPECT_EQ(opened(write_new_wif(design)).design.yarns, design.yarns);
  EXPECT_EQ(opened(write_preset_wif(design)).design.yarns, design.yarns);
  const std::string unnamed = without(without(write_new_wif(design), "Made Of"), "Cross-section");
  EXPECT_EQ(opened(unnamed).design.yarns, design.yarns) << "recognised by their optics";
}

TEST(Defaults, AFileThatNamesNoFibreIsRecognisedByItsOptics) {
  Design design = opened(fixture("twill.wif")).design;
  design.yarns = {with_cross_section(with_fibre(Yarn{}, Fibre::kSilk), CrossSection::kRound)};
  const std::string named = write_new_wif(design), unnamed = without(without(named, "Made Of"), "Cross-section");
  ASSERT_EQ(unnamed.find("Made Of"), std::string::npos);
  EXPECT_EQ(opened(unnamed).design.yarns, design.yarns);
  EXPECT_EQ(opened(without(named, "Cross-section")).design.yarns, design.yarns);
  std::string odd = named;
  odd.replace(odd.find("Made Of=Silk"), 12, "Made Of=Moss");
  const WifRead read = read_wif(odd);
  ASSERT_TRUE(read.file);
  EXPECT_EQ(read.file->design.yarns, design.yarns);
  EXPECT_FALSE(read.diagnostics.empty()) << "it says so";
}

}  // namespace
}  // namespace weftlight::wif
