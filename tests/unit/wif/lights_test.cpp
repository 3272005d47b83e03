// The light that a cloth is looked at in is kept by name; a name that nobody knows is the studio, and said so.

#include "draft/lights.h"

#include <gtest/gtest.h>

#include "wif/wif.h"

namespace weftlight::wif {
namespace {

TEST(Lights, AreKeptByName) {
  Design design;
  design.draft = blank_draft(4, 4, 2, 2);
  for (const LightingPreset& setup : kLightSetups) {
    design.scene = lit_by(design.scene, setup);
    const WifRead read = read_wif(write_new_wif(design));
    ASSERT_TRUE(read.file);
    EXPECT_EQ(read.file->design.scene, design.scene) << setup.id;
  }
}

TEST(Lights, ThePathOfAPictureAndTheExposureAreKept) {
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

TEST(Lights, AnUnknownNameIsTheStudio) {
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
