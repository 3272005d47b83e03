// The contents of the images of an exported set: means, normals, roughness, mipmaps, orientation.

#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "../files/sheet.h"
#include "../scratch.h"
#include "base/whole_files.h"
#include "files/files.h"
#include "sample_set.h"

namespace weftlight::texture_set {

using base::problem_of;
using cloth::Cloth, cloth::Maps, cloth::Period, cloth::bake, cloth::lay_out;
using design::Design, design::Twist, design::Yarn;
using draft::Face, draft::Rgb, draft::System, draft::drawdown;
using drape::sheet;
using files::Image, files::MipFormat, files::read_image;
using weaves::Lean, weaves::plain, weaves::twill;

namespace {

using nlohmann::json;

TEST(TextureSet, GreenOfNormalsFollowsTheEngine) {
  const Scratch scratch("green");
  ASSERT_EQ(problem_of(write_texture_set(scratch / "up", sample_design(), sheet(), options_for(targets::kGltf, 64))),
            "");
  ASSERT_EQ(
      problem_of(write_texture_set(scratch / "down", sample_design(), sheet(), options_for(targets::kUnreal, 64))), "");
  const Image up = *read_image(scratch / "up/sample_normal.png"), down = *read_image(scratch / "down/T_sample_N.png");
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
  SurfaceTexels surface = make_surface(cloth, maps, 256, 64);
  for (int level = 0; level < 9; ++level) {
    double kept = 0, covered = 0;
    for (const SurfaceTexel& t : surface.texels.at_)
      kept += static_cast<double>(t.base.g * t.coverage), covered += static_cast<double>(t.coverage);
    EXPECT_NEAR(kept / covered, sharp / share, 2e-3 * sharp / share) << "level " << level;
    surface = half_of(surface);
  }
}

TEST(TextureSet, LostNormalVarianceGoesIntoRoughness) {
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

TEST(TextureSet, AnglesOfAxesJumpWhereFewLie) {
  std::vector<SurfaceTexel> along_the_weft;
  for (const float xy : {-0.01f, 0.0f, 0.01f}) {
    SurfaceTexel t;
    t.coverage = 1, t.slope_cov = {0.2f, xy, 0.02f};
    along_the_weft.push_back(t);
  }
  const float from = axis_cut(along_the_weft);
  EXPECT_NEAR(from, 0.25f, 0.05f);
  for (const SurfaceTexel& t : along_the_weft) EXPECT_NEAR(axis_turn(ggx_alphas(t).wide_axis, from), 0.5f, 0.02f);
  EXPECT_NEAR(axis_turn({0, 1}, 0.2f), 0.25f, 1e-6);
  EXPECT_NEAR(axis_turn({0, -1}, 0.3f), 0.75f, 1e-6);
}

TEST(TextureSet, GapColourDoesNotBleed) {
  SurfaceTexel thread, gap;
  thread.coverage = 1;
  thread.base = {0.8f, 0.8f, 0.8f};
  const SurfaceTexel rim = merged(std::vector{thread, gap, gap, gap});
  EXPECT_NEAR(rim.base.r, 0.8f, 1e-3);
  EXPECT_NEAR(rim.coverage, 0.25f, 1e-6);
}

TEST(TextureSet, YarnsAreRougherAcrossTheFibre) {
  Design design = plain({2, 2});
  design.yarns[0].twist = Twist::kNone;
  const Cloth cloth = lay_out(design, drawdown(design.draft), Face::kFront, Period::kRepeat);
  const SurfaceTexels surface = make_surface(cloth, bake(cloth, {128, 128, 0}), 128, 128);
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

TEST(TextureSet, CoarserMipsAreRougher) {
  const Scratch scratch("mips");
  ASSERT_EQ(problem_of(write_texture_set(scratch / "raw", sample_design(), {}, options_for(targets::kRaw, 64))), "");
  const std::string file = scratch / "raw/sample_front_mips.exr";
  const std::array<size_t, 3> levels{0, 2, 4};  // the first has half the size of the set
  double before = 0;
  for (size_t level : levels) {
    const base::Result<Image> mip = read_image(file, static_cast<int>(level));
    ASSERT_TRUE(mip) << problem_of(mip);
    ASSERT_EQ(mip->width, 32 >> level);
    double rough = 0;
    for (size_t i = 0; i < mip->texels.size(); i += 5)
      rough += static_cast<double>(mip->texels[i + 3] + mip->texels[i + 4]);
    rough /= static_cast<double>(mip->texels.size() / 5);
    EXPECT_GT(rough, before) << "level " << level;
    before = rough;
  }
  EXPECT_FALSE(read_image(file, 6)) << "32 texels end at level 5";
}

/// Mean slant of the fibres on the ends, positive to the right.
double warp_slant(const std::string& file) {
  const base::Result<Image> read = read_image(file);
  if (!read) return 0;
  double sum = 0;
  for (size_t i = 0; i + 2 < read->texels.size(); i += static_cast<size_t>(read->channels)) {
    const double x = 2 * static_cast<double>(read->texels[i]) - 1;
    const double y = 2 * static_cast<double>(read->texels[i + 1]) - 1;
    if (std::abs(y) > std::abs(x)) sum += x * y;
  }
  return sum / static_cast<double>(read->width * read->height);
}

TEST(TextureSet, TwistIsTheSameOnBothFaces) {
  const Scratch scratch("twist");
  Design design = sample_design();
  for (Yarn& yarn : design.yarns) yarn.twist = Twist::kZ;
  ASSERT_EQ(problem_of(write_texture_set(scratch / "raw", design, {}, options_for(targets::kRaw, 64))), "");
  const double front = warp_slant(scratch / "raw/sample_front_tangent.png");
  const double back = warp_slant(scratch / "raw/sample_back_tangent.png");
  EXPECT_GT(std::abs(front), 0.01);
  EXPECT_LT(front * back, 0) << "the images of the back are mirrored";
}

TEST(TextureSet, OcclusionIsDarkBetweenThreads) {
  const Scratch scratch("occlusion");
  ASSERT_EQ(problem_of(write_texture_set(scratch / "set", sample_design(), {}, options_for(targets::kUnityUrp, 128))),
            "");
  const Image occlusion = *read_image(scratch / "set/sample_Occlusion.png");
  const auto [least, most] = std::minmax_element(occlusion.texels.begin(), occlusion.texels.end());
  EXPECT_LT(*least, 0.8f);
  EXPECT_GT(*most, 0.9f);
}

/// Black plain weave with one white end and one red pick: it differs from its mirror images and its half turn.
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
  ASSERT_EQ(
      problem_of(write_texture_set(scratch / "set", asymmetric_design(), {}, options_for(targets::kUnityUrp, 128))),
      "");
  const Image image = *read_image(scratch / "set/sample_BaseMap.png");
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

TEST(TextureSet, PinholesStayOpaque) {
  EXPECT_EQ(alpha_for(targets::kGltf, Alpha::kAuto, 0.99f), Alpha::kOpaque);
  EXPECT_EQ(alpha_for(targets::kGltf, Alpha::kAuto, 0.96f), Alpha::kOpaque) << "its folds would show through";
  EXPECT_EQ(alpha_for(targets::kGltf, Alpha::kAuto, 0.57f), Alpha::kBlend);
  EXPECT_EQ(alpha_for(targets::kBlender, Alpha::kAuto, 0.57f), Alpha::kHashed);
  EXPECT_EQ(alpha_for(targets::kGodot, Alpha::kAuto, 0.57f), Alpha::kHashed);
  EXPECT_EQ(alpha_for(targets::kGodot, Alpha::kBlend, 0.57f), Alpha::kBlend);
  EXPECT_EQ(alpha_for(targets::kGltf, Alpha::kHashed, 0.57f), Alpha::kBlend);
  EXPECT_EQ(alpha_for(targets::kGltf, Alpha::kMask, 0.99f), Alpha::kMask);
}

TEST(TextureSet, OneSamplePerTexelIsEnoughForWideThreads) {
  const Design design = twill({2, 2}, Lean::kRight, {8, 8});
  const Cloth cloth = lay_out(design, drawdown(design.draft), Face::kFront, Period::kRepeat);
  const int size = 64 * static_cast<int>(cloth.ends.size());  // the smallest size with one sample per texel
  const SurfaceTexels once = make_surface(cloth, bake(cloth, {size, size, 0}), size, size);
  const SurfaceTexels often = make_surface(cloth, bake(cloth, {4 * size, 4 * size, 0}), size, size);
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

/// Roughness of the narrow axis, and fraction of texels with coverage above one half, by level.
struct MipFigures {
  std::vector<double> roughness, covered;
};
MipFigures mips_of(const std::string& folder, int levels) {
  MipFigures out;
  for (int k = 0; k < levels; ++k) {
    const Image orm = *read_image(folder + "/sample_orm.dds", k),
                base = *read_image(folder + "/sample_basecolor.dds", k);
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

TEST(TextureSet, PrefilteredMipsGrowRougherAndKeepTheMask) {
  const Scratch scratch("own-mips");
  Design design = plain({2, 2});
  for (System s : {System::kWarp, System::kWeft}) design.draft.threads(s).spacing_mm.assign(2, 1.2f);
  for (Yarn& yarn : design.yarns) yarn.lobes.along_width = yarn.lobes.across_width = 0.1f;
  TextureSetOptions options = options_for(targets::kGltf, 256);
  options.mips = MipFormat::kDds, options.alpha = Alpha::kMask, options.distance_m = 0;
  ASSERT_EQ(problem_of(write_texture_set(scratch / "set", design, sheet(), options)), "");
  const json list = list_of(scratch / "set");
  EXPECT_EQ(list["maps"].size(), 12u) << "each image that is not constant and its mips, both faces";
  const MipFigures f = mips_of(scratch / "set", 9);
  EXPECT_GT(f.roughness[7], f.roughness[0] + 0.05) << "the spread of normals is lost";
  EXPECT_GT(f.covered[0], 0.2);
  EXPECT_LT(f.covered[0], 0.95);
  for (size_t k = 1; k < 6; ++k) EXPECT_NEAR(f.covered[k], f.covered[0], 0.07) << "level " << k;
  // The finest level is the image itself.
  const Image image = *read_image(scratch / "set/sample_orm.png"), finest = *read_image(scratch / "set/sample_orm.dds");
  for (size_t i = 0; i < 256 * 256; i += 97)
    EXPECT_NEAR(image.texels[3 * i + 1], finest.texels[static_cast<size_t>(finest.channels) * i + 1], 2.0f / 255);
}

std::string read_whole(const std::string& path) {
  const base::Result<std::string> read = base::read_file(path, base::kMaxFileBytes);
  EXPECT_TRUE(read) << problem_of(read);
  return read ? *read : std::string{};
}

/// Of a .dds in blocks. OpenImageIO 2.4 knows BC7 alone, not BC7 in sRGB, whose blocks are the same.
Image read_blocks(const std::string& path, int level) {
  constexpr size_t kFormat = 128;
  constexpr char kBc7 = 98, kBc7Srgb = 99;
  std::string bytes = read_whole(path);
  if (bytes[kFormat] == kBc7Srgb) bytes[kFormat] = kBc7;
  const std::string known = path + ".known.dds";
  std::ofstream(known, std::ios::binary) << bytes;
  const base::Result<Image> read = read_image(known, level);
  EXPECT_TRUE(read) << problem_of(read);
  return read ? *read : Image{};
}

/// Root mean square of the difference, of 255.
double rms(const Image& a, const Image& b) {
  EXPECT_EQ(a.texels.size(), b.texels.size());
  double sum = 0;
  for (size_t i = 0; i < std::min(a.texels.size(), b.texels.size()); ++i)
    sum += std::pow(255.0 * static_cast<double>(a.texels[i] - b.texels[i]), 2);
  return std::sqrt(sum / static_cast<double>(a.texels.size()));
}

TEST(TextureSet, MipsInBlocksKeepColoursAndMasksAndLeaveDirections) {
  const Scratch scratch("blocks");
  TextureSetOptions options = options_for(targets::kUnityHdrp, 256);
  for (const auto& [folder, format] : {std::pair{"plain", MipFormat::kDds}, {"blocks", MipFormat::kDdsBlocks}}) {
    options.mips = format;
    ASSERT_EQ(problem_of(write_texture_set(scratch / folder, sample_design(), sheet(), options)), "");
  }
  for (const char* image : {"NormalMap", "ThreadMap"})
    EXPECT_EQ(read_whole(scratch / (std::string("blocks/sample_") + image + ".dds")),
              read_whole(scratch / (std::string("plain/sample_") + image + ".dds")))
        << image;
  for (const char* image : {"BaseMap", "MaskMap"}) {
    const std::string plain = scratch / (std::string("plain/sample_") + image + ".dds"),
                      blocks = scratch / (std::string("blocks/sample_") + image + ".dds");
    EXPECT_LT(3.9 * static_cast<double>(read_whole(blocks).size()), static_cast<double>(read_whole(plain).size()))
        << image;
    for (int level = 0; level < 5; ++level)
      EXPECT_LT(rms(*read_image(plain, level), read_blocks(blocks, level)), 9) << image << " " << level;
  }
}

std::vector<std::string> channel_names(const std::string& image) {
  const auto in = OIIO::ImageInput::open(image);
  return in ? in->spec().channelnames : std::vector<std::string>();
}

TEST(TextureSet, ChannelsOfExrHaveNames) {
  const Scratch scratch("names_of_channels");
  ASSERT_EQ(problem_of(write_texture_set(scratch / "raw", sample_design(), {}, options_for(targets::kRaw, 32))), "");
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

TEST(TextureSet, BothFacesHaveTheirOwnImages) {
  const Scratch scratch("faces");
  Design design = twill({3, 1}, Lean::kRight, {8, 8});  // warp-faced; its back shows the weft
  design.draft.palette = {{0.1f, 0.1f, 0.4f}, {0.9f, 0.9f, 0.9f}};
  design.draft.warp.color.assign(design.draft.warp.color.size(), 0);
  design.draft.weft.color.assign(design.draft.weft.color.size(), 1);
  ASSERT_EQ(problem_of(write_texture_set(scratch / "set", design, sheet(), options_for(targets::kGltf, 64))), "");
  const Image front = *read_image(scratch / "set/sample_basecolor.png"),
              back = *read_image(scratch / "set/sample_back_basecolor.png");
  EXPECT_GT(mean_of(back, 0), mean_of(front, 0) + 0.1);
}

}  // namespace
}  // namespace weftlight::texture_set
