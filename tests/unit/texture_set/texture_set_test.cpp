#include "texture_set/texture_set.h"

#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

#include "../files/sheet.h"
#include "../scratch.h"
#include "draft/generators.h"
#include "texture_set/material_files.h"

namespace weftlight::texture_set {
namespace {

using nlohmann::json;
namespace fs = std::filesystem;

/// A two-coloured herringbone with a yarn of each kind; 16 ends x 4 picks a repeat, so it is not square.
Design sample_design() {
  Design design = herringbone({2, 2}, 8, {32, 16});
  design.title = "Sample";
  Yarn metal;
  metal.lobes.metallic = true;
  metal.lobes.across_width = 0.1f;
  design.yarns = {Yarn{}, metal};
  for (int e = 0; e < design.draft.ends(); e += 8) design.draft.warp.yarn[static_cast<size_t>(e)] = 1;
  return design;
}

TextureSetOptions options_for(Target target, int size = 128) {
  TextureSetOptions options;
  options.target = target, options.name = "sample", options.size = size;
  options.source = "sample.wif", options.draft_path = "drafts/sample.wif", options.program_version = "1.2.3";
  return options;
}

json list_of(const std::string& folder) { return json::parse(std::ifstream(folder + "/texture_set.json")); }

class EveryTarget : public testing::TestWithParam<Target> {};
INSTANTIATE_TEST_SUITE_P(All, EveryTarget,
                         testing::Values(Target::kRaw, Target::kGltf, Target::kUnreal, Target::kUnityHdrp,
                                         Target::kUnityUrp, Target::kGodot, Target::kBlender, Target::kU3m,
                                         Target::kMaterialX),
                         [](const auto& target) {
                           std::string name = target_name(target.param);
                           std::erase(name, '-');
                           return name;
                         });

/// Root mean square of the difference of two columns (or rows) of an image.
double step_rms(const Image& image, bool columns, int a, int b) {
  const int count = columns ? image.height : image.width;
  double sum = 0;
  for (int i = 0; i < count; ++i) {
    for (int c = 0; c < image.channels; ++c) {
      auto at = [&](int k) {
        const int x = columns ? k : i, y = columns ? i : k;
        return static_cast<double>(image.texels[static_cast<size_t>((y * image.width + x) * image.channels + c)]);
      };
      sum += (at(a) - at(b)) * (at(a) - at(b));
    }
  }
  return std::sqrt(sum / (count * image.channels));
}

void expect_seamless(const Image& image, const std::string& file) {
  for (bool columns : {true, false}) {
    const int n = columns ? image.width : image.height;
    double most = 0;
    for (int k = 0; k + 1 < n; ++k) most = std::max(most, step_rms(image, columns, k, k + 1));
    EXPECT_LE(step_rms(image, columns, n - 1, 0), 1.05 * most + 1e-3)
        << file << (columns ? ": left and right" : ": top and bottom");
  }
}

TEST_P(EveryTarget, IsCompleteSeamlessAndListed) {
  const Scratch scratch(std::string("set-") + target_name(GetParam()));
  const std::string folder = scratch / "sample";
  ASSERT_EQ(write_texture_set(folder, sample_design(), sheet(), options_for(GetParam())), "");
  const json list = list_of(folder);
  EXPECT_EQ(list["target"], target_name(GetParam()));
  EXPECT_EQ(list["source"], "sample.wif");
  EXPECT_EQ(list["program"], "weftlight 1.2.3");
  EXPECT_GT(list["size_mm"][0], 0);
  EXPECT_GT(list["size_mm"][0], list["size_mm"][1]);
  EXPECT_EQ(list["size_texels"][0], 128);
  EXPECT_EQ(list["maps"].size(), image_rows(GetParam()).size() * 2 + (GetParam() == Target::kRaw ? 6 : 0));
  std::set<std::string> expected{"texture_set.json"}, named{"README.md", "contact_sheet.png"};
  for (const json& map : list["maps"]) {
    const std::string file = map["file"];
    named.insert(file);
    const ReadImage read = read_image(folder + "/" + file);
    ASSERT_TRUE(read.image) << read.error;
    EXPECT_EQ(read.image->width, map["width"]);
    EXPECT_EQ(read.image->height, map["height"]);
    EXPECT_EQ(read.image->channels, static_cast<int>(map["channels"].size())) << file;
    if (file.find("_thread") == std::string::npos) expect_seamless(*read.image, file);
    for (float v : read.image->texels) ASSERT_TRUE(std::isfinite(v)) << file;
  }
  if (list.contains("material")) named.insert(list["material"]);
  for (const json& file : list["files"]) expected.insert(file);
  for (const std::string& file : named) EXPECT_TRUE(expected.contains(file)) << file;
  std::set<std::string> found;
  for (const auto& entry : fs::directory_iterator(folder)) found.insert(entry.path().filename());
  EXPECT_EQ(found, expected);
  std::ifstream readme(folder + "/README.md");
  EXPECT_EQ(std::count(std::istreambuf_iterator<char>(readme), {}, '\n'), 3);
  EXPECT_EQ(std::distance(fs::directory_iterator(scratch.folder), {}), 1) << "something temporary was left";
}

TEST(TextureSet, NamesAreThoseOfTheEngines) {
  const Scratch scratch("names");
  ASSERT_EQ(write_texture_set(scratch / "u", sample_design(), sheet(), options_for(Target::kUnreal, 32)), "");
  for (const char* file : {"T_sample_BC.png", "T_sample_N.png", "T_sample_ORM.png"})
    EXPECT_TRUE(fs::exists(scratch / ("u/" + std::string(file)))) << file;
}

TEST(TextureSet, GreenOfTheNormalsRunsAsTheEngineWants) {
  const Scratch scratch("green");
  ASSERT_EQ(write_texture_set(scratch / "up", sample_design(), sheet(), options_for(Target::kGltf, 64)), "");
  ASSERT_EQ(write_texture_set(scratch / "down", sample_design(), sheet(), options_for(Target::kUnreal, 64)), "");
  const Image up = *read_image(scratch / "up/sample_normal.png").image,
              down = *read_image(scratch / "down/T_sample_N.png").image;
  for (size_t i = 0; i < up.texels.size(); i += 3) {
    EXPECT_NEAR(up.texels[i], down.texels[i], 1e-6f);
    EXPECT_NEAR(up.texels[i + 1], 1 - down.texels[i + 1], 1.01f / 255);
  }
}

TEST(TextureSet, AverageColourSurvivesResampling) {
  const Design design = sample_design();
  const Cloth cloth = lay_out(design, drawdown(design.draft), Face::kFront, Period::kRepeat);
  const Maps maps = bake(cloth, {512, 128, 0});
  double sharp = 0, share = 0;
  for (size_t i = 0; i < maps.colour.at_.size(); ++i) {
    const bool metal = maps.system.at_[i] == 0 && cloth.ends[maps.thread.at_[i]].yarn == 1;
    const Rgb tint = design.yarns[1].lobes.specular_tint;
    const double lit = static_cast<double>(maps.colour.at_[i].g) * static_cast<double>(maps.groove.at_[i]);
    sharp += static_cast<double>(maps.coverage.at_[i]) * lit * (metal ? static_cast<double>(tint.g) : 1.0);
    share += static_cast<double>(maps.coverage.at_[i]);
  }
  Surface surface = make_surface(cloth, maps, 256, 64);
  for (int level = 0; level < 9; ++level) {
    double kept = 0, covered = 0;
    for (const SurfaceTexel& t : surface.texels.at_)
      kept += static_cast<double>(t.base.g * t.coverage), covered += static_cast<double>(t.coverage);
    EXPECT_NEAR(kept / covered, sharp / share, 2e-3 * sharp / share) << "level " << level;
    surface = half_of(surface);
  }
}

TEST(TextureSet, WhatNormalsLoseGoesIntoRoughness) {
  SurfaceTexel left, right;
  left.coverage = right.coverage = 1;
  left.slope_cov = right.slope_cov = {0.01f, 0, 0.04f};
  // Slopes of -1/2 and 1/2 in x: their mean is flat, their variance 1/4.
  const float n = 1 / std::sqrt(1.25f);
  left.normal = {-0.5f * n, 0, n};
  right.normal = {0.5f * n, 0, n};
  const SurfaceTexel both = merged(std::vector{left, right});
  EXPECT_NEAR(both.normal[0], 0, 1e-6);
  EXPECT_NEAR(both.normal[2], 1, 1e-6);
  EXPECT_NEAR(both.slope_cov[0], 0.26f, 1e-5);
  EXPECT_NEAR(both.slope_cov[2], 0.04f, 1e-5);
  // alpha = sqrt(2 variance).
  const GgxAlphas alphas = ggx_alphas(both);
  EXPECT_NEAR(alphas.wide, std::sqrt(0.52f), 1e-5);
  EXPECT_NEAR(alphas.narrow, std::sqrt(0.08f), 1e-5);
  EXPECT_NEAR(alphas.wide_axis[0], 1, 1e-5);
}

TEST(TextureSet, GapColourDoesNotBleed) {
  SurfaceTexel thread, gap;
  thread.coverage = 1;
  thread.base = {0.8f, 0.8f, 0.8f};
  const SurfaceTexel rim = merged(std::vector{thread, gap, gap, gap});
  EXPECT_NEAR(rim.base.r, 0.8f, 1e-3);
  EXPECT_NEAR(rim.coverage, 0.25f, 1e-6);
}

TEST(TextureSet, RoughAcrossTheFibreOfWarpAndWeft) {
  Design design = plain({2, 2});
  design.yarns[0].twist = Twist::kNone;
  const Cloth cloth = lay_out(design, drawdown(design.draft), Face::kFront, Period::kRepeat);
  const Surface surface = make_surface(cloth, bake(cloth, {128, 128, 0}), 128, 128);
  int along_v = 0, along_u = 0, warp = 0, weft = 0;
  for (const SurfaceTexel& t : surface.texels.at_) {
    if (t.coverage < 1) continue;
    const auto axis = ggx_alphas(t).wide_axis;
    // Yarns are rougher across: a warp's wide axis lies along u, a weft's along v.
    if (t.system == 0) ++warp, along_u += std::abs(axis[0]) > std::abs(axis[1]);
    else ++weft, along_v += std::abs(axis[1]) > std::abs(axis[0]);
  }
  EXPECT_GT(along_u, 0.9 * warp);
  EXPECT_GT(along_v, 0.9 * weft);
}

TEST(TextureSet, SizesArePowersOfTwoNearTheProportions) {
  EXPECT_EQ(texture_size(10, 10, 512).height, 512);
  EXPECT_EQ(texture_size(10, 5, 512).height, 256);
  EXPECT_EQ(texture_size(3, 10, 512).width, 128);
  EXPECT_EQ(texture_size(0.001f, 10, 512).width, 16);
}

TEST(TextureSet, MipsHoldRougherSurfacesTheCoarserTheyAre) {
  const Scratch scratch("mips");
  ASSERT_EQ(write_texture_set(scratch / "raw", sample_design(), {}, options_for(Target::kRaw, 64)), "");
  const std::string file = scratch / "raw/sample_front_mips.exr";
  const std::array<size_t, 3> levels{0, 2, 4};  // of which the first is half the set's size
  double before = 0;
  for (size_t level : levels) {
    const ReadImage mip = read_image(file, static_cast<int>(level));
    ASSERT_TRUE(mip.image) << mip.error;
    ASSERT_EQ(mip.image->width, 32 >> level);
    double rough = 0;
    for (size_t i = 0; i < mip.image->texels.size(); i += 5)
      rough += static_cast<double>(mip.image->texels[i + 3] + mip.image->texels[i + 4]);
    rough /= static_cast<double>(mip.image->texels.size() / 5);
    EXPECT_GT(rough, before) << "level " << level;
    before = rough;
  }
  EXPECT_FALSE(read_image(file, 6).image) << "32 texels end at level 5";
}

/// Mean slant of the fibres on the ends, right of up.
double warp_slant(const std::string& file) {
  const ReadImage read = read_image(file);
  if (!read.image) return 0;
  double sum = 0;
  for (size_t i = 0; i + 2 < read.image->texels.size(); i += static_cast<size_t>(read.image->channels)) {
    const double x = 2 * static_cast<double>(read.image->texels[i]) - 1;
    const double y = 2 * static_cast<double>(read.image->texels[i + 1]) - 1;
    if (std::abs(y) > std::abs(x)) sum += x * y;
  }
  return sum / static_cast<double>(read.image->width * read.image->height);
}

TEST(TextureSet, YarnsAreTwistedAlikeOnBothFaces) {
  const Scratch scratch("twist");
  Design design = sample_design();
  for (Yarn& yarn : design.yarns) yarn.twist = Twist::kZ;
  ASSERT_EQ(write_texture_set(scratch / "raw", design, {}, options_for(Target::kRaw, 64)), "");
  const double front = warp_slant(scratch / "raw/sample_front_tangent.png");
  const double back = warp_slant(scratch / "raw/sample_back_tangent.png");
  EXPECT_GT(std::abs(front), 0.01);
  EXPECT_LT(front * back, 0) << "the back's images are seen mirrored";
}

TEST(TextureSet, OcclusionDarkensWhereThreadsDive) {
  const Scratch scratch("occlusion");
  ASSERT_EQ(write_texture_set(scratch / "set", sample_design(), {}, options_for(Target::kUnityUrp, 128)), "");
  const Image occlusion = *read_image(scratch / "set/sample_Occlusion.png").image;
  const auto [least, most] = std::minmax_element(occlusion.texels.begin(), occlusion.texels.end());
  EXPECT_LT(*least, 0.8f);
  EXPECT_GT(*most, 0.9f);
}

TEST(TextureSet, NamesOfFilesAreTame) {
  EXPECT_EQ(file_name_of("My draft (2)"), "My_draft_2");
  EXPECT_EQ(file_name_of("../../etc"), "etc");
  EXPECT_EQ(file_name_of("\xC3\xA4"), "cloth");
}

TEST(TextureSet, FoldersOfOthersAreLeftAlone) {
  const Scratch scratch("others");
  fs::create_directories(scratch / "mine");
  std::ofstream(scratch / "mine/letter.txt") << "dear";
  EXPECT_NE(write_texture_set(scratch / "mine", sample_design(), sheet(), options_for(Target::kGltf, 32)), "");
  EXPECT_EQ(std::distance(fs::directory_iterator(scratch / "mine"), {}), 1);
  TextureSetOptions force = options_for(Target::kGltf, 32);
  force.force = true;
  EXPECT_EQ(write_texture_set(scratch / "mine", sample_design(), sheet(), force), "");
  EXPECT_TRUE(fs::exists(scratch / "mine/letter.txt"));
}

TEST(TextureSet, OnlyWhatTheSameSetListsIsReplaced) {
  const Scratch scratch("same");
  const TextureSetOptions options = options_for(Target::kGltf, 32);
  ASSERT_EQ(write_texture_set(scratch / "set", sample_design(), sheet(), options), "");
  // An artist's own work stands beside it; an older version of the set had an image more.
  std::ofstream(scratch / "set/scene.blend") << "work";
  json list = list_of(scratch / "set");
  std::ofstream(scratch / "set/sample_old.png") << "old";
  list["files"].push_back("sample_old.png");
  std::ofstream(scratch / "set/texture_set.json") << list;
  ASSERT_EQ(write_texture_set(scratch / "set", sample_design(), sheet(), options), "");
  EXPECT_TRUE(fs::exists(scratch / "set/scene.blend"));
  EXPECT_FALSE(fs::exists(scratch / "set/sample_old.png"));
  // What was not listed is another's, whatever its name.
  list = list_of(scratch / "set");
  list["files"].erase(std::find(list["files"].begin(), list["files"].end(), "sample_orm.png"));
  std::ofstream(scratch / "set/texture_set.json") << list;
  std::ofstream(scratch / "set/sample_orm.png") << "painted over";
  EXPECT_NE(write_texture_set(scratch / "set", sample_design(), sheet(), options), "");
  EXPECT_EQ(fs::file_size(scratch / "set/sample_orm.png"), 12u);
  EXPECT_EQ(std::distance(fs::directory_iterator(scratch.folder), {}), 1) << "something temporary was left";
}

TEST(TextureSet, SetsOfOthersAreNotReplaced) {
  const Scratch scratch("sets");
  ASSERT_EQ(write_texture_set(scratch / "set", sample_design(), sheet(), options_for(Target::kUnreal, 32)), "");
  EXPECT_NE(who_is_there(scratch / "set", options_for(Target::kGltf, 32)), "");
  EXPECT_NE(write_texture_set(scratch / "set", sample_design(), sheet(), options_for(Target::kGltf, 32)), "");
  TextureSetOptions namesake = options_for(Target::kUnreal, 32);
  namesake.draft_path = "other/sample.wif";
  EXPECT_NE(write_texture_set(scratch / "set", sample_design(), sheet(), namesake), "");
  namesake.force = true;
  EXPECT_EQ(write_texture_set(scratch / "set", sample_design(), sheet(), namesake), "");
}

TEST(TextureSet, WhatAKilledExportLeftGoes) {
  const Scratch scratch("killed");
  const pid_t child = fork();
  if (child == 0) _exit(0);
  ASSERT_GT(child, 0);
  waitpid(child, nullptr, 0);  // now no process has its number
  const std::string left = scratch / ("set.part-" + std::to_string(child) + "-0");
  fs::create_directories(left);
  std::ofstream(left + "/.weftlight_texture_set");
  std::ofstream(left + "/sample_orm.png") << "half";
  fs::create_directories(scratch / "set.part-time");
  const std::string living = scratch / ("set.part-" + std::to_string(getpid()) + "-77");
  fs::create_directories(living);
  std::ofstream(living + "/.weftlight_texture_set");
  ASSERT_EQ(write_texture_set(scratch / "set", sample_design(), sheet(), options_for(Target::kGltf, 32)), "");
  EXPECT_FALSE(fs::exists(left));
  EXPECT_TRUE(fs::exists(living));
  EXPECT_TRUE(fs::exists(scratch / "set.part-time"));
}

TEST(TextureSet, FailureLeavesTheOldSet) {
  const Scratch scratch("failure");
  ASSERT_EQ(write_texture_set(scratch / "set", sample_design(), sheet(), options_for(Target::kGltf, 32)), "");
  Mesh broken = sheet();
  broken.index[0] = 1000;
  TextureSetOptions larger = options_for(Target::kGltf, 64);
  EXPECT_NE(write_texture_set(scratch / "set", sample_design(), broken, larger), "");
  EXPECT_EQ(list_of(scratch / "set")["size_texels"][0], 32);
  EXPECT_EQ(std::distance(fs::directory_iterator(scratch.folder), {}), 1);
}

/// Plain weave with one white end in black, and one red pick: neither half turn nor mirror is the same.
Design asymmetric_design() {
  Design design = plain({8, 8});
  design.draft.palette = {{0.05f, 0.05f, 0.05f}, {1, 1, 1}, {1, 0, 0}};
  design.draft.warp.color.assign(8, 0);
  design.draft.weft.color.assign(8, 0);
  design.draft.warp.color[1] = 1;  // end 2
  design.draft.weft.color[2] = 2;  // pick 3
  return design;
}

TEST(TextureSet, EndOneIsAtTheRightAndPickOneAtTheTop) {
  const Scratch scratch("way_up");
  ASSERT_EQ(write_texture_set(scratch / "set", asymmetric_design(), {}, options_for(Target::kUnityUrp, 128)), "");
  const Image image = *read_image(scratch / "set/sample_BaseMap.png").image;
  std::vector<double> white(8), red(8);
  for (int y = 0; y < 128; ++y) {
    for (int x = 0; x < 128; ++x) {
      const float* t = &image.texels[static_cast<size_t>((y * 128 + x) * image.channels)];
      white[static_cast<size_t>(x / 16)] += static_cast<double>(t[1]);
      red[static_cast<size_t>(y / 16)] += static_cast<double>(t[0] - t[1]);
    }
  }
  EXPECT_EQ(std::max_element(white.begin(), white.end()) - white.begin(), 6) << "end 2 is second from the right";
  EXPECT_EQ(std::max_element(red.begin(), red.end()) - red.begin(), 2) << "pick 3 is third from the top";
}

/// Means of a channel.
double mean_of(const Image& image, int channel) {
  double sum = 0;
  for (size_t i = static_cast<size_t>(channel); i < image.texels.size(); i += static_cast<size_t>(image.channels))
    sum += static_cast<double>(image.texels[i]);
  return sum / (static_cast<double>(image.texels.size()) / image.channels);
}

TEST(TextureSet, PinholesAreNoWindows) {
  EXPECT_EQ(alpha_for(Target::kGltf, Alpha::kAuto, 0.99f), Alpha::kOpaque);
  EXPECT_EQ(alpha_for(Target::kGltf, Alpha::kAuto, 0.96f), Alpha::kOpaque) << "its folds would show through";
  EXPECT_EQ(alpha_for(Target::kGltf, Alpha::kAuto, 0.57f), Alpha::kBlend);
  EXPECT_EQ(alpha_for(Target::kBlender, Alpha::kAuto, 0.57f), Alpha::kHashed);
  EXPECT_EQ(alpha_for(Target::kGltf, Alpha::kHashed, 0.57f), Alpha::kBlend);
  EXPECT_EQ(alpha_for(Target::kGltf, Alpha::kMask, 0.99f), Alpha::kMask);
}

TEST(TextureSet, BandsAreTheWholeCutUp) {
  // Eight times as many texels as one piece may have, of a cloth of few threads; and one of many.
  Design design = sample_design();
  const Cloth cloth = lay_out(design, drawdown(design.draft), Face::kFront, Period::kRepeat);
  FaceOptions options;
  options.size = {2048, 2048};
  options.footprint_mm = 0.8f;
  const FaceSource source(cloth, options);
  ASSERT_LT(source.band(), 2048);
  const Surface a = source.rows(0, source.band()), b = source.rows(source.band(), 2 * source.band());
  // No seam: neighbours across the bands differ no more than neighbours within.
  const auto apart = [](const Surface& p, int y, const Surface& q, int z) {
    double sum = 0;
    for (int x = 0; x < p.texels.width; ++x) {
      const SurfaceTexel &s = p.texels.at(x, y), &t = q.texels.at(x, z);
      sum += std::abs(static_cast<double>(s.base.g - t.base.g)) +
             std::abs(static_cast<double>(s.occlusion - t.occlusion)) +
             std::abs(static_cast<double>(s.slope_cov[0] - t.slope_cov[0]));
    }
    return sum;
  };
  const int last = a.texels.height - 1;
  const double within = 0.5 * (apart(a, last - 1, a, last) + apart(b, 0, b, 1));  // on both sides of the border
  EXPECT_LT(apart(a, last, b, 0), 1.5 * within + 1);
}

TEST(TextureSet, OneSampleATexelWillDoWhereThreadsAreWide) {
  const Design design = twill({2, 2}, Lean::kRight, {8, 8});
  const Cloth cloth = lay_out(design, drawdown(design.draft), Face::kFront, Period::kRepeat);
  const int size = 64 * static_cast<int>(cloth.ends.size());  // the least that is sampled once a texel
  const Surface once = make_surface(cloth, bake(cloth, {size, size, 0}), size, size);
  const Surface often = make_surface(cloth, bake(cloth, {4 * size, 4 * size, 0}), size, size);
  double colour = 0, normal = 0, mean = 0;
  for (size_t i = 0; i < once.texels.at_.size(); ++i) {
    const SurfaceTexel &a = once.texels.at_[i], &b = often.texels.at_[i];
    colour += std::pow(static_cast<double>(a.base.g - b.base.g), 2.0);
    normal += static_cast<double>(glm::dot(a.normal - b.normal, a.normal - b.normal)) / 3;
    mean += static_cast<double>(a.base.g - b.base.g);
  }
  const double count = static_cast<double>(once.texels.at_.size());
  EXPECT_LT(std::sqrt(colour / count), 0.04);
  EXPECT_LT(std::sqrt(normal / count), 0.07);  // twice what an image of 0..1 holds
  EXPECT_NEAR(mean / count, 0, 5e-4);
}

/// Roughness of the narrow axis, and the coverage above one half, by level.
struct MipFigures {
  std::vector<double> roughness, covered;
};
MipFigures mips_of(const std::string& folder, int levels) {
  MipFigures out;
  for (int k = 0; k < levels; ++k) {
    const Image orm = *read_image(folder + "/sample_orm.dds", k).image,
                base = *read_image(folder + "/sample_basecolor.dds", k).image;
    double sum = 0, above = 0;
    const size_t texels = static_cast<size_t>(orm.width) * static_cast<size_t>(orm.height);
    for (size_t i = 0; i < texels; ++i) {
      sum += static_cast<double>(orm.texels[i * static_cast<size_t>(orm.channels) + 1]);
      above += base.texels[i * static_cast<size_t>(base.channels) + 3] >= 0.5f;
    }
    out.roughness.push_back(sum / static_cast<double>(texels)),
        out.covered.push_back(above / static_cast<double>(texels));
  }
  return out;
}

TEST(TextureSet, MipsOfOurOwnGrowRougherAndKeepWhatIsCutOut) {
  const Scratch scratch("own-mips");
  Design design = plain({2, 2});
  for (System s : {System::kWarp, System::kWeft}) design.draft.threads(s).spacing_mm.assign(2, 1.2f);
  for (Yarn& yarn : design.yarns) yarn.lobes.along_width = yarn.lobes.across_width = 0.1f;
  TextureSetOptions options = options_for(Target::kGltf, 256);
  options.mips = MipContainer::kDds, options.alpha = Alpha::kMask, options.distance_m = 0;
  ASSERT_EQ(write_texture_set(scratch / "set", design, sheet(), options), "");
  const json list = list_of(scratch / "set");
  EXPECT_EQ(list["maps"].size(), 20u) << "each image and its mips, both faces";
  const MipFigures f = mips_of(scratch / "set", 9);
  EXPECT_GT(f.roughness[7], f.roughness[0] + 0.05) << "the spread of normals is lost";
  EXPECT_GT(f.covered[0], 0.2);
  EXPECT_LT(f.covered[0], 0.95);
  for (size_t k = 1; k < 6; ++k) EXPECT_NEAR(f.covered[k], f.covered[0], 0.07) << "level " << k;
  // The finest level is the image itself.
  const Image image = *read_image(scratch / "set/sample_orm.png").image,
              finest = *read_image(scratch / "set/sample_orm.dds").image;
  for (size_t i = 0; i < 256 * 256; i += 97)
    EXPECT_NEAR(image.texels[3 * i + 1], finest.texels[static_cast<size_t>(finest.channels) * i + 1], 2.0f / 255);
}

TEST(TextureSet, BothFacesHaveTheirOwnImages) {
  const Scratch scratch("faces");
  Design design = twill({3, 1}, Lean::kRight, {8, 8});  // warp-faced; its back shows the weft
  design.draft.palette = {{0.1f, 0.1f, 0.4f}, {0.9f, 0.9f, 0.9f}};
  design.draft.warp.color.assign(design.draft.warp.color.size(), 0);
  design.draft.weft.color.assign(design.draft.weft.color.size(), 1);
  ASSERT_EQ(write_texture_set(scratch / "set", design, sheet(), options_for(Target::kGltf, 64)), "");
  const Image front = *read_image(scratch / "set/sample_basecolor.png").image,
              back = *read_image(scratch / "set/sample_back_basecolor.png").image;
  EXPECT_GT(mean_of(back, 0), mean_of(front, 0) + 0.1);
}

TEST(TextureSet, AMillimetreIsAMillimetre) {
  const Mesh quad = scale_quad();
  for (size_t i = 0; i < 4; ++i) {
    const size_t j = (i + 1) % 4;
    const double along = std::hypot(static_cast<double>(quad.position_mm[j][0] - quad.position_mm[i][0]),
                                    static_cast<double>(quad.position_mm[j][1] - quad.position_mm[i][1]));
    const double uv = std::hypot(static_cast<double>(quad.uv_mm[j][0] - quad.uv_mm[i][0]),
                                 static_cast<double>(quad.uv_mm[j][1] - quad.uv_mm[i][1]));
    EXPECT_NEAR(along, uv, 1e-3);
  }
  // Every engine's file has the same scale.
  const Scratch scratch("scale");
  const Cloth cloth = lay_out(sample_design(), drawdown(sample_design().draft), Face::kFront, Period::kRepeat);
  const std::string scale = number(1 / static_cast<double>(cloth.width_mm)),
                    width = number(static_cast<double>(cloth.width_mm));
  const auto holds = [&](Target target, const std::string& file, const std::string& text) {
    const std::string folder = scratch / target_name(target);
    ASSERT_EQ(write_texture_set(folder, sample_design(), sheet(), options_for(target, 32)), "");
    std::ifstream in(folder + "/" + file);
    const std::string all{std::istreambuf_iterator<char>(in), {}};
    EXPECT_NE(all.find(text), std::string::npos) << file << " lacks " << text;
  };
  holds(Target::kGodot, "sample.tres", "uv1_scale = Vector3(" + scale);
  holds(Target::kUnityUrp, "sample.mat", "m_Scale: {x: " + scale);
  holds(Target::kUnreal, "sample_import.py", "SIZE_MM = (" + width);
  holds(Target::kBlender, "sample.py", "SIZE_MM = (" + width);
  holds(Target::kMaterialX, "sample.mtlx", "value=\"" + scale);
  holds(Target::kMaterialX, "sample_openpbr.usda", "sample.mtlx");
}

std::string text_of(const std::string& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

TEST(TextureSet, UnityReadsEachMapAsItIs) {
  const Scratch scratch("unity-maps");
  for (const Target target : {Target::kUnityUrp, Target::kUnityHdrp}) {
    const std::string folder = scratch / target_name(target);
    ASSERT_EQ(write_texture_set(folder, sample_design(), {}, options_for(target, 32)), "");
    for (const json& map : list_of(folder)["maps"]) {
      const std::string file = map["file"], meta = text_of(folder + "/" + file + ".meta");
      EXPECT_NE(meta.find(map["color_space"] == "sRGB" ? "sRGBTexture: 1\n" : "sRGBTexture: 0\n"), std::string::npos)
          << file;
      const bool normal = file.find("_Normal") != std::string::npos;
      EXPECT_NE(meta.find(normal ? "textureType: 1\n" : "textureType: 0\n"), std::string::npos) << file;
    }
  }
}

/// HDRP adds its smoothness and normal, less a half and doubled, to those of the cloth that it is laid over.
TEST(TextureSet, HdrpsThreadMapChangesNothingOnTheMean) {
  const Scratch scratch("thread-map");
  ASSERT_EQ(write_texture_set(scratch / "h", sample_design(), {}, options_for(Target::kUnityHdrp, 128)), "");
  const Image map = *read_image(scratch / "h/sample_ThreadMap.png").image;
  ASSERT_EQ(map.channels, 4);
  std::array<double, 4> mean{};
  for (size_t i = 0; i < map.texels.size(); ++i)
    mean[i % 4] += static_cast<double>(map.texels[i]) / (map.width * map.height);
  EXPECT_GT(mean[0], 0.9) << "occlusion multiplies";
  EXPECT_NEAR(mean[1], 0.5, 0.02) << "normal, y";
  EXPECT_NEAR(mean[2], 0.5, 0.01) << "smoothness";
  EXPECT_NEAR(mean[3], 0.5, 0.02) << "normal, x";
  EXPECT_NE(text_of(scratch / "h/README.md").find("ThreadMap is for Fabric's thread slot"), std::string::npos);
}

/// Unity's inspector would set these, but an import does not: a blended material without them is drawn opaque.
TEST(TextureSet, UnityMaterialsSayHowTheyBlend) {
  const Scratch scratch("unity");
  TextureSetOptions options = options_for(Target::kUnityUrp, 32);
  const auto material = [&](Target target, Alpha alpha) {
    options.target = target, options.alpha = alpha;
    const std::string folder = scratch / (std::string(target_name(target)) + alpha_name(alpha));
    EXPECT_EQ(write_texture_set(folder, sample_design(), {}, options), "");
    return text_of(folder + "/sample.mat");
  };
  for (const Target target : {Target::kUnityUrp, Target::kUnityHdrp}) {
    const std::string blended = material(target, Alpha::kBlend), opaque = material(target, Alpha::kOpaque),
                      cut = material(target, Alpha::kMask);
    for (const char* line : {"RenderType: Transparent\n", "_DstBlend: 10\n", "_ZWrite: 0\n"})
      EXPECT_NE(blended.find(line), std::string::npos) << line;
    for (const char* line : {"RenderType: Opaque\n", "_DstBlend: 0\n", "_ZWrite: 1\n"})
      EXPECT_NE(opaque.find(line), std::string::npos) << line;
    EXPECT_NE(cut.find("RenderType: TransparentCutout\n"), std::string::npos);
  }
}

TEST(TextureSet, SaysWhereAMaskCloses) {
  Design design = plain({2, 2});
  TextureSetOptions options = options_for(Target::kGltf, 128);
  options.alpha = Alpha::kMask;
  EXPECT_TRUE(warnings_of(design, options).empty()) << "a dense cloth";
  for (System s : {System::kWarp, System::kWeft}) design.draft.threads(s).spacing_mm.assign(2, 1.2f);
  EXPECT_EQ(warnings_of(design, options).size(), 1u);
  options.mips = MipContainer::kKtx2;
  EXPECT_TRUE(warnings_of(design, options).empty()) << "mips of our own keep what is cut out";
  options.mips = {}, options.target = Target::kUnreal;
  EXPECT_TRUE(warnings_of(design, options).empty()) << "its importer is told to";
}

TEST(TextureSet, TilesOfManyRepeats) {
  const Design design = sample_design();
  const Cloth one = lay_out(design, drawdown(design.draft), Face::kFront, Period::kRepeat);
  const Cloth many = tiled(one, 3, 2);
  EXPECT_FLOAT_EQ(many.width_mm, 3 * one.width_mm);
  EXPECT_EQ(many.picks.size(), 2 * one.picks.size());
  EXPECT_EQ(many.up.get(5, 20), one.up.get(5 % one.up.rows(), 20 % one.up.cols()));
  TextureSetOptions options = options_for(Target::kGltf, 16);
  EXPECT_EQ(warnings_of(design, options).size(), 1u) << "16 ends in 16 texels";
  options.size = 128;
  EXPECT_TRUE(warnings_of(design, options).empty());
  EXPECT_GE(static_cast<float>(size_for(design, 20, 50)), 20 * 50.0f);
}

TEST(TextureSet, TheSameBytesEveryTime) {
  const Scratch scratch("again");
  for (const Target target : {Target::kU3m, Target::kMaterialX, Target::kGltf}) {
    const std::string a = scratch / (std::string("a/") + target_name(target)),
                      b = scratch / (std::string("b/") + target_name(target));
    ASSERT_EQ(write_texture_set(a, sample_design(), sheet(), options_for(target, 32)), "");
    ASSERT_EQ(write_texture_set(b, sample_design(), sheet(), options_for(target, 32)), "");
    for (const auto& entry : fs::directory_iterator(a)) {
      std::ifstream one(entry.path(), std::ios::binary), two(b / entry.path().filename(), std::ios::binary);
      EXPECT_EQ(std::string(std::istreambuf_iterator<char>(one), {}),
                std::string(std::istreambuf_iterator<char>(two), {}))
          << entry.path();
    }
  }
}

std::vector<std::string> channel_names(const std::string& image) {
  const auto in = OIIO::ImageInput::open(image);
  return in ? in->spec().channelnames : std::vector<std::string>();
}

TEST(TextureSet, ChannelsOfExrHaveNames) {
  const Scratch scratch("names_of_channels");
  ASSERT_EQ(write_texture_set(scratch / "raw", sample_design(), {}, options_for(Target::kRaw, 32)), "");
  const json list = list_of(scratch / "raw");
  for (const json& map : list["maps"]) {
    const std::string file = map["file"];
    if (!file.ends_with(".exr")) continue;
    std::set<std::string> listed;
    for (const auto& [name, words] : map["channels"].items()) listed.insert(name);
    const std::vector<std::string> found = channel_names(scratch / ("raw/" + file));
    EXPECT_EQ(listed, std::set<std::string>(found.begin(), found.end())) << file;
  }
  EXPECT_EQ(channel_names(scratch / "raw/sample_front_height.exr"), std::vector<std::string>{"height.mm"});
}

TEST(TextureSet, EmptyDraftIsAnError) {
  const Scratch scratch("empty");
  EXPECT_NE(write_texture_set(scratch / "set", Design{}, sheet(), options_for(Target::kGltf, 32)), "");
  EXPECT_TRUE(fs::is_empty(scratch.folder));
}

}  // namespace
}  // namespace weftlight::texture_set
