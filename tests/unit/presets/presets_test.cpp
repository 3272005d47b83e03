// The shipped drafts and yarns are what their recipes give, and cloth that a weaver would weave.
// WEFTLIGHT_UPDATE_PRESETS=1 writes the files anew.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include "analysis/floats.h"
#include "analysis/hand.h"
#include "analysis/layers.h"
#include "draft/repeat.h"
#include "paths.h"
#include "recipes.h"
#include "wif/wif.h"

namespace weftlight::wif {
namespace {

using namespace analysis;

std::string presets_path(const std::string& path) {
  return (std::filesystem::path(WEFTLIGHT_TESTS_DIR).parent_path() / "presets" / path).string();
}

bool updating() { return std::getenv("WEFTLIGHT_UPDATE_PRESETS") != nullptr; }

TEST(Presets, FilesAreWhatTheRecipesGive) {
  for (const PresetRecipe& recipe : preset_recipes()) {
    const std::string path = presets_path(recipe.path), bytes = write_new_wif(recipe.design);
    if (updating()) {
      std::filesystem::create_directories(std::filesystem::path(path).parent_path());
      ASSERT_EQ(write_file_atomically(path, bytes), "");
    }
    const FileBytes file = read_file(path);
    ASSERT_EQ(file.error, "") << path;
    EXPECT_EQ(file.bytes, bytes) << path << ": run presets_test with WEFTLIGHT_UPDATE_PRESETS=1";
  }
}

TEST(Presets, ClothsHangAsTheirKindsDo) {
  const auto hand = [](const char* cloth) {
    const WifRead read = read_wif(read_file(presets_path("cloths/" + std::string(cloth) + ".wif")).bytes);
    return analysis::cloth_hand(read.file.value().design);
  };
  // Bending lengths of such cloths, mm: charmeuse 10 to 14, shirting 16 to 20, 14 oz denim 22 to 30, linen 25 to 35.
  EXPECT_LT(hand("silk_charmeuse").bending_length_mm, 15);
  EXPECT_NEAR(hand("chambray").bending_length_mm, 18, 3);
  EXPECT_GT(hand("denim").bending_length_mm, 23);
  EXPECT_GT(hand("linen").bending_length_mm, 25);
  EXPECT_LT(hand("organza").bending_length_mm, 0.9 * hand("denim").bending_length_mm);
  EXPECT_NEAR(hand("denim").kg_per_m2, 0.475, 0.03);
  EXPECT_LT(hand("organza").kg_per_m2, 0.03);
  // Satin charmeuse of polyester falls as that of silk does: its round weft is not bound by gum.
  EXPECT_LT(hand("polyester_satin_charmeuse").bending_length_mm, 15);
}

TEST(Presets, ClothsWeighWhatSuchClothsWeigh) {
  const auto g_per_m2 = [](const char* cloth) {
    const WifRead read = read_wif(read_file(presets_path("cloths/" + std::string(cloth) + ".wif")).bytes);
    return 1000 * analysis::cloth_hand(read.file.value().design).kg_per_m2;
  };
  // By count and sett: Nm 5.6 at 9.6 and 9 a centimetre is 349 g/m2 with crimp; 12.5 oz denim 424; gum silk 23.
  EXPECT_NEAR(g_per_m2("tweed"), 349, 35);
  EXPECT_NEAR(g_per_m2("cotton_denim"), 424, 42);
  EXPECT_NEAR(g_per_m2("gabardine"), 235, 24);
  EXPECT_NEAR(g_per_m2("organza"), 21, 5);
  EXPECT_LT(g_per_m2("silk_charmeuse"), 115);
}

TEST(Presets, FilesReadWithoutAComplaint) {
  for (const PresetRecipe& recipe : preset_recipes()) {
    const WifRead read = read_wif(read_file(presets_path(recipe.path)).bytes);
    ASSERT_TRUE(read.file) << recipe.path;
    EXPECT_TRUE(is_consistent(read.file->design)) << recipe.path;
    for (const Diagnostic& d : read.diagnostics) {
      ADD_FAILURE() << recipe.path << ":" << d.line << ": " << d.text << " " << d.remedy;
    }
    EXPECT_EQ(read.file->design, recipe.design) << recipe.path;
  }
}

TEST(Presets, NoStrayFiles) {
  const auto recipes = preset_recipes();
  for (const char* folder : {"drafts", "yarns", "cloths"}) {
    for (const auto& entry : std::filesystem::directory_iterator(presets_path(folder))) {
      const std::string path = std::string(folder) + "/" + entry.path().filename().string();
      EXPECT_TRUE(std::ranges::any_of(recipes, [&](const PresetRecipe& r) { return r.path == path; })) << path;
    }
  }
}

TEST(Presets, AreSoundCloth) {
  for (const PresetRecipe& recipe : preset_recipes()) {
    const Design& d = recipe.design;
    ASSERT_TRUE(is_consistent(d)) << recipe.path;
    const BitMatrix cells = drawdown(d.draft);
    const LongestFloats f = longest_floats(cells);
    const auto [least, most] = std::minmax({f.warp_front, f.warp_back, f.weft_front, f.weft_back});
    EXPECT_GE(least, 1) << recipe.path << ": a thread is never bound";
    EXPECT_LE(most, 8) << recipe.path << ": a float would catch";
    EXPECT_LE(layers(cells).size(), 1u) << recipe.path;
    // The sheet of the draft holds whole repeats, so that it can be laid side by side.
    const Repeat r = design_repeat(d, cells);
    EXPECT_EQ(d.draft.ends() % r.ends, 0);
    for (const System system : {System::kWarp, System::kWeft}) {
      for (const float mm : d.draft.threads(system).spacing_mm) {
        EXPECT_GT(mm, 0.07f) << recipe.path;
        EXPECT_LT(mm, 2.0f) << recipe.path;
      }
    }
  }
}

}  // namespace
}  // namespace weftlight::wif
