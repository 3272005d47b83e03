// The plan of a texture export, the thread that writes it, and its preview.

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <thread>

#include "../comes_true.h"
#include "../scratch.h"
#include "session/jobs/export_plan.h"
#include "session/jobs/export_preview.h"
#include "session/jobs/exporter.h"
#include "texture_set/set_folder.h"
#include "weaves/weaves.h"

namespace weftlight::session {

using design::Design;
using draft::Face;
using files::MipFormat;
using texture_set::ExportTarget, texture_set::TextureSetOptions;
using weaves::Lean, weaves::twill;

namespace {

namespace fs = std::filesystem;

Design sample() { return twill({2, 2}, Lean::kRight, {8, 8}); }

ExportPlan plan_into(const std::string& folder, std::vector<const ExportTarget*> targets, int size = 64) {
  ExportPlan plan;
  plan.folder = folder, plan.targets = std::move(targets), plan.size = size;
  return plan;
}

TEST(ExportPlanTest, EachTargetHasItsOwnFolder) {
  const Design design = sample();
  const std::vector<ExportJob> one =
      jobs_of(plan_into("out", {&texture_set::targets::kGodot}), design, "a/My draft.wif", "1");
  ASSERT_EQ(one.size(), 1u);
  EXPECT_EQ(one[0].folder, "out/My_draft");
  EXPECT_EQ(one[0].options.source, "My draft.wif");
  EXPECT_FALSE(one[0].options.force);
  const std::vector<ExportJob> two =
      jobs_of(plan_into("out", {&texture_set::targets::kGodot, &texture_set::targets::kRaw}), design, "", "1");
  ASSERT_EQ(two.size(), 2u);
  EXPECT_EQ(two[0].folder, "out/untitled/godot");
  EXPECT_EQ(two[1].folder, "out/untitled/raw");
}

TEST(ExportPlanTest, MipFilesAreWrittenOnlyForTargetsWithoutTheirOwn) {
  ExportPlan plan = plan_into("out", {&texture_set::targets::kGodot, &texture_set::targets::kRaw});
  EXPECT_FALSE(jobs_of(plan, sample(), "", "1")[0].options.mips);
  plan.mips = MipFormat::kKtx2;
  const std::vector<ExportJob> jobs = jobs_of(plan, sample(), "", "1");
  EXPECT_EQ(jobs[0].options.mips, MipFormat::kKtx2);
  EXPECT_FALSE(jobs[1].options.mips) << "a raw set has mips of its own";
}

TEST(ExportPlanTest, LevelsOfDetailFollowTheirSet) {
  ExportPlan plan = plan_into("out", {&texture_set::targets::kGodot, &texture_set::targets::kRaw}, 1024);
  plan.lods = true;
  const std::vector<ExportJob> jobs = jobs_of(plan, sample(), "a/twill.wif", "1");
  ASSERT_EQ(jobs.size(), 4u) << "a raw set has none";
  EXPECT_EQ(jobs[0].folder, "out/twill/godot");
  EXPECT_EQ(jobs[1].folder, "out/twill-lod1/godot");
  EXPECT_EQ(jobs[2].options.size, 64);
  EXPECT_EQ(figures_of(sample(), jobs).images, figures_of(sample(), {jobs[0], jobs[3]}).images);
}

TEST(ExportPlanTest, OneTargetIsAlwaysChosen) {
  ExportPlan plan;
  toggle(plan, &texture_set::targets::kGltf);
  EXPECT_EQ(plan.targets, std::vector{&texture_set::targets::kGltf});
  toggle(plan, &texture_set::targets::kU3m);
  toggle(plan, &texture_set::targets::kGltf);
  EXPECT_EQ(plan.targets, std::vector{&texture_set::targets::kU3m});
}

TEST(ExportPlanTest, TheFiguresMatchTheWrittenFiles) {
  const Scratch scratch("export-figures");
  const Design design = sample();
  ExportPlan plan = plan_into(scratch / "out", {&texture_set::targets::kUnityUrp});
  const std::vector<ExportJob> jobs = jobs_of(plan, design, "x.wif", "1");
  const ExportFigures f = figures_of(design, jobs);
  EXPECT_EQ(f.images, 8);
  EXPECT_EQ(f.set.ends, 4u);  // a repeat
  EXPECT_EQ(f.set.size.width, 64);
  EXPECT_FLOAT_EQ(f.texels_a_thread, 16);
  EXPECT_TRUE(f.why.empty());
  // Base, mask and normal in four channels, occlusion in one; both faces; a third more for mips.
  EXPECT_NEAR(static_cast<double>(f.texel_bytes), 2 * 64 * 64 * (4 + 4 + 4 + 1) * 4 / 3, 8);
  plan.by_density = true, plan.texels_per_mm = 100;
  const ExportFigures dense = figures_of(design, jobs_of(plan, design, "x.wif", "1"));
  EXPECT_GE(static_cast<float>(dense.set.size.width), 100 * dense.set.width_mm);
  plan.by_density = false, plan.size = 512, plan.tile_cm = 50;
  EXPECT_FALSE(figures_of(design, jobs_of(plan, design, "x.wif", "1")).why.empty()) << "threads blur";
}

TEST(ExportPlanTest, ByteCountsAreReadable) {
  EXPECT_EQ(shown_bytes(1200), "1.2 kB");
  EXPECT_EQ(shown_bytes(55924053), "56 MB");
  EXPECT_EQ(shown_bytes(999'700'000), "1.0 GB");
}

TEST(ExporterTest, WritesEverySetWithProgress) {
  const Scratch scratch("exporter");
  const auto design = std::make_shared<const Design>(sample());
  const std::vector<ExportJob> jobs =
      jobs_of(plan_into(scratch / "out", {&texture_set::targets::kUnityUrp, &texture_set::targets::kGodot}), *design,
              "x.wif", "1");
  std::atomic<int> woken{0};
  Exporter exporter([&] { ++woken; });
  EXPECT_FALSE(exporter.began());
  exporter.start(jobs, design);
  ASSERT_TRUE(comes_true([&] { return !exporter.busy(); }));
  const Exporter::State state = exporter.state();
  EXPECT_TRUE(state.problems.empty()) << state.problems.front();
  EXPECT_EQ(state.written, (std::vector{jobs[0].folder, jobs[1].folder}));
  EXPECT_FLOAT_EQ(state.share, 1);
  EXPECT_GT(woken, 4);
  EXPECT_TRUE(exporter.take_change());
  EXPECT_EQ(exporter.take_message(), "Exported 2 sets to " + (scratch / "out/x"));
  EXPECT_EQ(exporter.take_message(), "");
  EXPECT_TRUE(fs::exists(jobs[1].folder + "/texture_set.json"));
  // The same sets may be replaced, which is told with their number; another's files are in the way.
  EXPECT_TRUE(in_the_way(jobs).empty());
  EXPECT_GT(replaced_files(jobs), 20);
  std::vector<ExportJob> others = jobs;
  others[0].options.draft_path = "somewhere/else/x.wif";
  EXPECT_EQ(in_the_way(others).size(), 1u);
  EXPECT_EQ(in_the_way(others)[0].find("--force"), std::string::npos) << "words of the command line";
}

TEST(ExporterTest, AStoppedExportKeepsTheEarlierSet) {
  const Scratch scratch("exporter-stop");
  const auto design = std::make_shared<const Design>(sample());
  const std::vector<ExportJob> jobs =
      jobs_of(plan_into(scratch / "out", {&texture_set::targets::kUnityUrp}, 4096), *design, "x.wif", "1");
  Exporter exporter([] {});
  exporter.start(jobs, design);
  ASSERT_TRUE(comes_true([&] { return exporter.state().share > 0; }));
  exporter.stop();
  ASSERT_TRUE(comes_true([&] { return exporter.state().stopped; }));
  EXPECT_TRUE(exporter.state().written.empty());
  EXPECT_TRUE(exporter.state().problems.empty());
  ASSERT_TRUE(comes_true([&] { return fs::is_empty(scratch / "out"); })) << "something half-written was left";
}

TEST(ExporterTest, TheNewestDraftIsWritten) {
  const Scratch scratch("exporter-newest");
  const auto first = std::make_shared<const Design>(sample());
  Design changed = sample();
  changed.title = "changed";
  Exporter exporter([] {});
  exporter.start(jobs_of(plan_into(scratch / "out", {&texture_set::targets::kUnityUrp}, 4096), *first, "x.wif", "1"),
                 first);
  ASSERT_TRUE(comes_true([&] { return exporter.state().share > 0; }));
  const auto second = std::make_shared<const Design>(changed);
  exporter.start(jobs_of(plan_into(scratch / "out", {&texture_set::targets::kUnityUrp}, 64), *second, "x.wif", "1"),
                 second);
  ASSERT_TRUE(comes_true([&] { return !exporter.busy(); }));
  EXPECT_EQ(exporter.state().written.size(), 1u);
  std::ifstream list(scratch / "out/x/texture_set.json");
  EXPECT_NE(std::string(std::istreambuf_iterator<char>(list), {}).find("changed"), std::string::npos);
  EXPECT_EQ(exporter.take_message(), "Exported the texture set to " + (scratch / "out/x"));
}

TEST(ExportPreviewTest, PreviewsEveryImageWholeAndByChannel) {
  const Design design = sample();
  TextureSetOptions options;
  options.target = &texture_set::targets::kGltf, options.name = "x";
  PreviewSizes sizes;
  sizes.swatch_width = 200, sizes.swatch_height = 60, sizes.side = 32;
  const ExportPreview p = export_preview(design, Face::kFront, options, sizes);
  ASSERT_EQ(p.images.size(), texture_set::targets::kGltf.images.size());
  EXPECT_EQ(p.images[0].file, "x_basecolor.png");
  EXPECT_EQ(p.images[0].about, "sRGB");
  ASSERT_EQ(p.images[0].channels.size(), 4u);
  EXPECT_EQ(p.images[0].channels[3].words, "coverage");
  EXPECT_EQ(p.pixels.size(), static_cast<size_t>(p.width) * static_cast<size_t>(p.height));
  for (const ShownImage& image : p.images) {
    for (const ShownChannel& c : image.channels) {
      EXPECT_LE(c.at.x + c.at.width, p.width);
      EXPECT_LE(c.at.y + c.at.height, p.height);
    }
  }
  // A channel alone is what it holds of the whole.
  const ShownImage& normal = p.images[2];
  const auto pixel = [&](const PictureRect& r) {
    return p.pixels[static_cast<size_t>(r.y + 5) * static_cast<size_t>(p.width) + static_cast<size_t>(r.x + 7)];
  };
  for (int c = 0; c < 3; ++c)
    EXPECT_EQ(pixel(normal.at) >> (8 * c) & 255, pixel(normal.channels[static_cast<size_t>(c)].at) & 255);
  EXPECT_GT(bytes_on_disk(p, {1024, 1024}), bytes_on_disk(p, {512, 512}));
  EXPECT_EQ(export_preview(Design{}, Face::kFront, options, sizes).images.size(), 0u);
}

}  // namespace
}  // namespace weftlight::session
