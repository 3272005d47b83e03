// Lighting presets are stored by id; an unknown id is read as the studio, with a warning.

#include "design/lights.h"

#include <gtest/gtest.h>

#include "wif/wif.h"

namespace weftlight::wif {

using design::Design, design::LightingPreset, design::kLightingPresets, design::lit_by, design::lit_by_environment;
using draft::blank_draft;

namespace {

TEST(Lights, AreStoredById) {
  Design design;
  design.draft = blank_draft(4, 4, 2, 2);
  for (const LightingPreset& preset : kLightingPresets) {
    design.scene = lit_by(design.scene, preset);
    const WifRead read = read_wif(write_new_wif(design));
    ASSERT_TRUE(read.file);
    EXPECT_EQ(read.file->design.scene, design.scene) << preset.id;
  }
}

TEST(Lights, EnvironmentMapAndExposureAreStored) {
  Design design;
  design.draft = blank_draft(4, 4, 2, 2);
  design.scene = lit_by_environment(design.scene, "/pictures/old hall;1.EXR");
  design.scene.surroundings = design.scene.simulated_drape = true;
  design.look.automatic_exposure = false;
  const WifRead read = read_wif(write_new_wif(design));
  ASSERT_TRUE(read.file);
  EXPECT_EQ(read.file->design.scene, design.scene);
  EXPECT_EQ(read.file->design.look, design.look);
}

TEST(Lights, AnUnknownIdIsTheStudio) {
  Design design;
  design.draft = blank_draft(4, 4, 2, 2);
  design.scene.lights = "gallery";
  std::string bytes = write_new_wif(design);
  const size_t at = bytes.find("Lights=gallery");
  ASSERT_NE(at, std::string::npos);
  bytes.replace(at, 14, "Lights=../moon");
  const WifRead read = read_wif(bytes);
  ASSERT_TRUE(read.file);
  EXPECT_EQ(read.file->design.scene.lights, "studio");
  EXPECT_EQ(read.diagnostics.size(), 1u);
}

}  // namespace
}  // namespace weftlight::wif
