// `weftlight reference --fibres`: what it prints, what it refuses, and the memory of the shipped cloths.

#include <filesystem>

#include "base/resources.h"
#include "base/whole_files.h"
#include "cloth/cloth.h"
#include "draft/drawdown.h"
#include "reference/fibre_scene.h"
#include "scratch_folder.h"
#include "wif/wif.h"

namespace weftlight::commands {
namespace {

using base::presets_dir;
using base::read_file;

using Fibres = ScratchFolder;

std::string denim() { return presets_dir() + "/cloths/denim.wif"; }

TEST_F(Fibres, a_near_picture_states_what_it_is_made_of_and_its_memory) {
  const Ran ran = run({"reference", denim(), "-o", path("near.png"), "--fibres", "--spp", "2", "--size", "24x16",
                       "--mesh", "plane", "--yarns-per-pixel", "0.06"});
  if (ran.code == kNoGraphics) GTEST_SKIP() << "no graphics";
  EXPECT_EQ(ran.code, kDone) << ran.said;
  for (const char* word : {" mm, ", "hairs and loops", " MB, estimated "})
    EXPECT_NE(ran.out.find(word), std::string::npos) << ran.out;
  EXPECT_TRUE(std::filesystem::exists(path("near.png")));
}

TEST_F(Fibres, quiet_states_nothing) {
  const Ran ran = run({"reference", denim(), "-o", path("near.png"), "--fibres", "--spp", "1", "--size", "8x8",
                       "--mesh", "plane", "--yarns-per-pixel", "0.03", "--quiet"});
  if (ran.code == kNoGraphics) GTEST_SKIP() << "no graphics";
  EXPECT_EQ(ran.code, kDone) << ran.said;
  EXPECT_EQ(ran.out + ran.said, "");
}

TEST_F(Fibres, a_view_of_too_much_cloth_is_refused_with_the_figure) {
  const Ran ran = run({"reference", denim(), "-o", path("far.png"), "--fibres", "--size", "64x48", "--mesh", "skirt"});
  if (ran.code == kNoGraphics) GTEST_SKIP() << "no graphics";
  EXPECT_EQ(ran.code, kBadInput) << ran.said;
  EXPECT_NE(ran.said.find("denim.wif"), std::string::npos) << ran.said;
  EXPECT_NE(ran.said.find("2048 MB are allowed; show less"), std::string::npos) << ran.said;
  EXPECT_TRUE(files().empty());
}

TEST_F(Fibres, a_number_of_bounces_is_for_tubes) {
  const Ran ran = run({"reference", denim(), "-o", path("near.png"), "--fibres", "--bounces", "2"});
  EXPECT_EQ(ran.code, kUsage);
  EXPECT_NE(ran.said.find("--fibres"), std::string::npos) << ran.said;
}

TEST_F(Fibres, eight_by_eight_millimetres_of_every_shipped_cloth_stay_within_2_GB) {
  int cloths = 0;
  for (const auto& file : std::filesystem::directory_iterator(presets_dir() + "/cloths")) {
    const wif::WifRead read = wif::read_wif(read_file(file.path().string()).value_or(""));
    ASSERT_TRUE(read.file) << file.path();
    Design design = read.file->design;
    reference::FibreOptions options;
    options.high_mm = {8, 8};
    options.raised = design.finish.raised;
    design.finish.raised = 0;
    const cloth::Cloth laid =
        cloth::lay_out(design, draft::drawdown(design.draft), draft::Face::kFront, cloth::Period::kRepeat);
    const reference::FibreFigures figures = reference::fibre_figures(laid, options);
    EXPECT_LT(figures.bytes, options.max_bytes) << file.path().filename();
    EXPECT_GT(figures.fibres, 300) << file.path().filename();
    std::printf("  %-32s %3d threads, %6lld fibres, %5.2f million curves, %4lld MB\n", file.path().filename().c_str(),
                figures.threads, static_cast<long long>(figures.fibres), static_cast<double>(figures.curves) * 1e-6,
                static_cast<long long>(figures.bytes >> 20));
    ++cloths;
  }
  EXPECT_GT(cloths, 15);
}

}  // namespace
}  // namespace weftlight::commands
