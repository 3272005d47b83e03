// The shipped drafts and yarns equal the output of their recipes, and are sound cloth.
// WEFTLIGHT_UPDATE_PRESETS=1 rewrites the files.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "analysis/floats.h"
#include "analysis/handle.h"
#include "analysis/weave_layers.h"
#include "design/fibre.h"
#include "design/repeat.h"
#include "design/yarn_presets.h"
#include "drape/stiffness.h"
#include "paths.h"
#include "recipes.h"
#include "wif/wif.h"

namespace weftlight::wif {

using base::read_file, base::write_file_atomically;
using design::Design, design::Repeat, design::Yarn, design::design_repeat, design::is_consistent,
    design::packing_fraction, design::yarn_presets;
using draft::BitMatrix, draft::System, draft::drawdown;

namespace {

using analysis::LongestFloats, analysis::longest_floats, analysis::weave_layers;

std::string presets_path(const std::string& path) {
  return (std::filesystem::path(WEFTLIGHT_TESTS_DIR).parent_path() / "presets" / path).string();
}

bool updating() { return std::getenv("WEFTLIGHT_UPDATE_PRESETS") != nullptr; }

TEST(Presets, FilesEqualTheRecipes) {
  for (const PresetRecipe& recipe : preset_recipes()) {
    const std::string path = presets_path(recipe.path), bytes = write_preset_wif(recipe.design);
    if (updating()) {
      std::filesystem::create_directories(std::filesystem::path(path).parent_path());
      ASSERT_EQ(problem_of(write_file_atomically(path, bytes)), "");
    }
    const base::Result<std::string> file = read_file(path);
    ASSERT_TRUE(file) << problem_of(file);
    EXPECT_EQ(*file, bytes) << path << ": run presets_test with WEFTLIGHT_UPDATE_PRESETS=1";
  }
}

analysis::ClothHandle hand_of(const std::string& cloth) {
  const WifRead read = read_wif(read_file(presets_path("cloths/" + cloth + ".wif")).value_or(""));
  return analysis::cloth_handle(read.file.value().design);
}

struct UsualCloth {
  const char *name, *said;
  int least, most;  // usual weight of such cloths, g/m2
  const char* hang;
};
// Cottons and wools: J. J. Pizzuto's Fabric Science, the mills' own lists in ounces a square yard (33.9 g/m2); silks in
// momme (4.34 g/m2).
constexpr UsualCloth kUsual[] = {
    {"chambray", "shirting", 110, 150, "medium"},
    {"oxford", "shirting", 130, 200, "medium"},
    {"chintz", "furnishing, light", 100, 150, "medium"},
    {"denim", "13 to 15 oz", 440, 510, "stiff"},
    {"cotton_denim", "12 to 14 oz", 400, 490, "stiff"},
    {"cotton_twill", "drill, chino", 220, 320, "medium"},
    {"gabardine", "worsted suiting", 220, 300, "medium"},
    {"flannel", "woollen", 230, 340, "medium"},
    {"tweed", "Harris, light to medium", 300, 480, "stiff"},
    {"linen", "table, furnishing", 200, 300, "stiff"},
    {"linen_plain", "dress", 150, 250, "stiff"},
    {"damask", "table", 180, 270, "stiff"},
    {"silk_satin", "duchesse, 28 to 40 momme", 120, 175, "medium"},
    {"silk_charmeuse", "16 to 22 momme", 69, 96, "limp"},
    {"silk_crepe_de_chine", "12 to 18 momme", 52, 78, "limp"},
    {"polyester_satin_charmeuse", "lining and dress", 65, 110, "limp"},
    {"shot_taffeta", "silk", 60, 110, "medium"},
    {"organza", "4 to 8 momme", 17, 35, "medium"},
    {"ottoman", "furnishing", 250, 420, "medium"},
};

TEST(Presets, YarnsOfClothsHaveTheirFibre) {
  for (const PresetRecipe& recipe : cloth_recipes()) {
    for (const Yarn& yarn : recipe.design.yarns) {
      const std::string fibre = ready_yarn(yarn.fibre).name;
      const auto said = [&](const char* word) { return yarn.name.find(word) != std::string::npos; };
      const char* expected = said("otton")                                ? "Cotton"
                             : said("inen")                               ? "Linen"
                             : said("oollen") || said("orsted")           ? "Wool"
                             : said("ilk") || said("zine") || said("ram") ? "Silk"
                                                                          : "Polyester filament";
      EXPECT_EQ(fibre, expected) << recipe.path << ": " << yarn.name;
      EXPECT_GT(yarn.tex, 0) << recipe.path << ": " << yarn.name;
      EXPECT_GT(packing_fraction(yarn), 0.15) << recipe.path << ": " << yarn.name;
      EXPECT_LT(packing_fraction(yarn), 0.8) << recipe.path << ": " << yarn.name;
    }
  }
}

TEST(Presets, ClothsHaveUsualWeightAndBendingLength) {
  std::ifstream file(WEFTLIGHT_SOURCE_DIR "/docs/measured.md");
  std::stringstream docs;
  docs << file.rdbuf();
  for (const UsualCloth& usual : kUsual) {
    const analysis::ClothHandle hand = hand_of(usual.name);
    const double g_per_m2 = 1000 * hand.kg_per_m2;
    EXPECT_GE(g_per_m2, usual.least) << usual.name;
    EXPECT_LE(g_per_m2, usual.most) << usual.name;
    const double c = hand.bending_length_mm;
    EXPECT_STREQ(drape::kDrapeStiffnessNames[static_cast<size_t>(drape::drape_stiffness_of(c))], usual.hang)
        << usual.name << " " << c;
    char row[160];
    std::snprintf(row, sizeof row, "| %s | %.0f | %d to %d (%s) | %.1f | %s |\n", usual.name, g_per_m2, usual.least,
                  usual.most, usual.said, c, usual.hang);
    EXPECT_NE(docs.str().find(row), std::string::npos) << "docs/measured.md shall hold\n" << row;
  }
  EXPECT_EQ(std::size(kUsual), std::ranges::count_if(preset_recipes(), [](const PresetRecipe& r) {
              return r.path.starts_with("cloths/");
            }));
}

TEST(Presets, FilesReadWithoutDiagnostics) {
  for (const PresetRecipe& recipe : preset_recipes()) {
    const WifRead read = read_wif(read_file(presets_path(recipe.path)).value_or(""));
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
    EXPECT_LE(most, 8) << recipe.path << ": a float would snag";
    EXPECT_LE(weave_layers(cells).size(), 1u) << recipe.path;
    // The draft has whole repeats, so that it can be tiled.
    const Repeat r = design_repeat(d, cells);
    EXPECT_EQ(d.draft.ends() % r.ends, 0);
    for (const System system : {System::kWarp, System::kWeft}) {
      for (const float mm : d.draft.threads(system).spacing_mm) {
        EXPECT_GT(mm, 0.07f) << recipe.path;
        EXPECT_LT(mm, 2.5f) << recipe.path;  // cords
      }
    }
  }
}

}  // namespace
}  // namespace weftlight::wif
