// Images for recolouring: that they give the base colour again, and that the list says what they hold.

#include "texture_set/recolour.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <functional>

#include "../files/sheet.h"
#include "../scratch.h"
#include "base/whole_files.h"
#include "design/srgb.h"
#include "paths.h"
#include "sample_set.h"
#include "wif/wif.h"

namespace weftlight::texture_set {

using base::problem_of;
using design::srgb_decoded;
using drape::sheet;
using files::read_image;

namespace {

using nlohmann::json;
namespace fs = std::filesystem;

/// Three colours, one of them black, of which white cannot be computed backwards.
Design three_colors() {
  Design design = sample_design();
  design.draft.palette = {{0, 0, 0}, {0.9f, 0.2f, 0.1f}, {0.2f, 0.5f, 0.9f}, {1, 1, 0}};
  for (int& c : design.draft.warp.color) c = 0;
  for (int e = 0; e < design.draft.ends(); e += 4) design.draft.warp.color[static_cast<size_t>(e)] = 2;
  for (int& c : design.draft.weft.color) c = 1;
  return design;
}

class Recolour : public testing::Test {
 protected:
  void SetUp() override {
    TextureSetOptions options = options_for(targets::kUnreal, 128);
    options.masks = true;
    ASSERT_EQ(problem_of(write_texture_set(folder(), three_colors(), sheet(), options)), "");
  }
  std::string folder() const { return scratch_ / "set"; }
  Image image(const std::string& file) const {
    const base::Result<Image> read = read_image(folder() + "/" + file);
    EXPECT_TRUE(read) << problem_of(read);
    return read ? *read : Image{};
  }

 private:
  Scratch scratch_{"recolour"};
};

using ImageReader = std::function<Image(const std::string&)>;

/// Mean difference of the base colour and white_scale x white x sum of share x colour, in linear light, by channel;
/// shares of either face.
std::array<double, 3> differences(const json& list, const ImageReader& image, const std::string& name,
                                  const std::string& face, const std::string& base_suffix) {
  const Image base = image(name + base_suffix + ".png"), white = image(name + "_white.png");
  const json& colors = list["recolour"]["colors"];
  const float scale = list["recolour"]["white_scale"][name.ends_with("_back") ? "back" : "front"].get<float>();
  std::vector<Image> shares;
  for (const json& color : colors) shares.push_back(image(color["share"][face]));
  const auto step = static_cast<size_t>(base.channels);
  std::array<double, 3> off{};
  for (size_t i = 0; i < white.texels.size(); ++i) {
    const size_t at = i / 3, c = i % 3;
    float sum = 0;
    for (size_t k = 0; k < shares.size(); ++k) {
      const size_t channel = std::string("RGB").find(colors[k]["share"]["channel"].get<std::string>());
      sum += shares[k].texels[at * 3 + channel] * colors[k]["linear"][c].get<float>();
    }
    off[c] += std::abs(
        static_cast<double>(scale * srgb_decoded(white.texels[i]) * sum - srgb_decoded(base.texels[at * step + c])));
  }
  for (double& channel : off) channel /= static_cast<double>(white.texels.size() / 3);
  return off;
}

double difference(const json& list, const ImageReader& image, const std::string& name, const std::string& face) {
  const std::array<double, 3> off = differences(list, image, name, face, "_BC");
  return (off[0] + off[1] + off[2]) / 3;
}

// A wrong order of colours, a mirrored row or a factor of the fit that is left out would all show here. Measured: 0.004
// and 0.005, by the 8 bits of the shares and by the edges of threads.
TEST_F(Recolour, WhiteTimesTheColoursOfTheSharesIsTheBaseColour) {
  const json list = list_of(folder());
  const auto read = [this](const std::string& file) { return image(file); };
  EXPECT_LT(difference(list, read, "T_sample", "front"), 0.008);
  EXPECT_LT(difference(list, read, "T_sample_back", "back"), 0.008);
  EXPECT_GT(difference(list, read, "T_sample", "back"), 0.03) << "shares of the other face";
}

TEST_F(Recolour, WhiteThatFitsIsNotScaled) {
  const json scale = list_of(folder())["recolour"]["white_scale"];
  Image white = image("T_sample_white.png");
  const float most = std::ranges::max(white.texels);
  EXPECT_TRUE(scale["front"] == 1.0 || most > 0.99f) << "as much of the 8 bits as there is: " << most;
}

/// Silk of dark colours, whose highlights make the fit brighten its base colour beyond that of white yarn.
TEST(RecolourOptions, WhiteOfDarkShinyClothIsScaledToFit) {
  const wif::WifRead read =
      wif::read_wif(base::read_file(WEFTLIGHT_SOURCE_DIR "/presets/cloths/shot_taffeta.wif").value_or(""));
  ASSERT_TRUE(read.file);
  const Scratch scratch("taffeta");
  TextureSetOptions options = options_for(targets::kUnityUrp, 128);
  options.masks = true;
  ASSERT_EQ(problem_of(write_texture_set(scratch / "set", read.file->design, sheet(), options)), "");
  const json list = list_of(scratch / "set");
  const auto image = [&](const std::string& file) { return *read_image(scratch / ("set/" + file)); };
  for (const std::string face : {"front", "back"}) {
    const std::string name = face == "front" ? "sample" : "sample_back";
    EXPECT_GT(list["recolour"]["white_scale"][face], 2.0);
    EXPECT_LT(std::ranges::max(differences(list, image, name, face, "_BaseMap")), 0.02)
        << "cut off at 1: 0.037 of green";
  }
}

TEST(RecolourOptions, ReadmeSaysWhatTheImagesAreFor) {
  const Scratch scratch("readme");
  TextureSetOptions options = options_for(targets::kU3m, 16);
  const auto readme = [&] { return base::read_file(scratch / "set/README.md").value_or(""); };
  ASSERT_EQ(problem_of(write_texture_set(scratch / "set", three_colors(), sheet(), options)), "");
  EXPECT_EQ(readme().find("recolour"), std::string::npos);
  options.masks = true;
  ASSERT_EQ(problem_of(write_texture_set(scratch / "set", three_colors(), sheet(), options)), "");
  EXPECT_NE(readme().find("`recolour` in texture_set.json"), std::string::npos) << readme();
}

TEST(RecolourOptions, UnityImportsThemAsNumbers) {
  const Scratch scratch("unity-masks");
  TextureSetOptions options = options_for(targets::kUnityUrp, 16);
  options.masks = true;
  ASSERT_EQ(problem_of(write_texture_set(scratch / "set", three_colors(), sheet(), options)), "");
  const auto says = [&](const std::string& image, const std::string& line) {
    const std::string meta = base::read_file(scratch / ("set/" + image + ".png.meta")).value_or("");
    return meta.find(" " + line + "\n") != std::string::npos;
  };
  for (const std::string face : {"sample", "sample_back"}) {
    EXPECT_TRUE(says(face + "_white", "sRGBTexture: 1")) << face;
    for (const char* of : {"_threads", "_shares1", "_index"}) EXPECT_TRUE(says(face + of, "sRGBTexture: 0")) << of;
    EXPECT_TRUE(says(face + "_shares1", "enableMipMap: 1")) << face;
    for (const char* line : {"enableMipMap: 0", "filterMode: 0", "textureCompression: 0"})
      EXPECT_TRUE(says(face + "_index", line)) << line;
  }
}

TEST(RecolourOptions, UnrealsScriptImportsThem) {
  const Scratch scratch("unreal-masks");
  ASSERT_EQ(problem_of(write_texture_set(scratch / "set", three_colors(), sheet(), options_for(targets::kUnreal, 16))),
            "");
  const std::string script = base::read_file(scratch / "set/sample_import.py").value_or("");
  std::vector<RecolourImage> all = recolour_images(kMaxSharedColors);
  const auto shares =
      std::erase_if(all, [](const RecolourImage& image) { return image.suffix.starts_with("_shares") && !image.srgb; });
  EXPECT_NE(script.find("{\"_shares%d\" % k: (False, COMPRESSION.TC_MASKS) for k in range(1, " +
                        std::to_string(shares + 1) + ")}"),
            std::string::npos);
  for (const RecolourImage& image : all)
    EXPECT_NE(script.find("\"" + image.suffix + "\": (" + (image.srgb ? "True" : "False")), std::string::npos)
        << image.suffix;
}

TEST_F(Recolour, TheListNamesTheColoursThatThreadsHave) {
  const json colors = list_of(folder())["recolour"]["colors"];
  ASSERT_EQ(colors.size(), 3u) << "yellow is in the palette alone";
  EXPECT_EQ(colors[0]["color"], "#000000");
  EXPECT_EQ(colors[1]["color"], "#e6331a");
  EXPECT_EQ(colors[1]["palette"], 2);
  EXPECT_EQ(colors[1]["ends"], 0);
  EXPECT_EQ(colors[1]["picks"], 4);
  EXPECT_EQ(colors[2]["ends"], 4);
  EXPECT_EQ(colors[1]["name"], "#e6331a Cotton");
}

TEST_F(Recolour, IndicesAreThoseOfTheListAndFollowTheThreads) {
  const Image index = image("T_sample_index.png"), threads = image("T_sample_threads.png");
  std::array<size_t, 3> seen{};
  size_t weft = 0, half = 0;
  for (size_t i = 0; i < index.texels.size(); i += 3) {
    const auto k = static_cast<size_t>(std::lround(index.texels[i] * 255));
    ASSERT_LT(k, seen.size());
    ++seen[k];
    if (threads.texels[i + 1] > 0.51f) {
      ++weft;
      EXPECT_EQ(k, 1u) << "all picks are red, and no end is";
    } else if (threads.texels[i + 1] > 0.49f) {
      ++half;
    }
    EXPECT_NEAR(threads.texels[i] + threads.texels[i + 1], 1, 0.005);
  }
  EXPECT_TRUE(seen[1] >= weft && seen[1] <= weft + half) << seen[1] << " of " << weft << " and " << half;
  EXPECT_GT(seen[0], seen[2]);
  EXPECT_GT(seen[2], 0u);
}

TEST(RecolourOptions, ASetHasNoneUnlessAsked) {
  const Scratch scratch("plain");
  ASSERT_EQ(problem_of(write_texture_set(scratch / "set", three_colors(), sheet(), options_for(targets::kUnreal, 16))),
            "");
  EXPECT_FALSE(fs::exists(scratch / "set/T_sample_white.png"));
  EXPECT_FALSE(list_of(scratch / "set").contains("recolour"));
  TextureSetOptions with = options_for(targets::kUnreal, 16);
  const std::string key = key_of(with);
  with.masks = true;
  EXPECT_NE(key_of(with), key) << "--resume makes the set again";
}

TEST(RecolourOptions, MoreColoursThanAnIndexHoldsAreRefusedWithTheirNumber) {
  Design design = weaves::plain({300, 2});
  design.draft.palette.clear();
  for (int e = 0; e < 300; ++e) {
    design.draft.palette.push_back({static_cast<float>(e) / 300.0f, 0, 0});
    design.draft.warp.color[static_cast<size_t>(e)] = e;
  }
  const Scratch scratch("many");
  TextureSetOptions options = options_for(targets::kUnreal, 16);
  options.masks = true;
  const auto done = write_texture_set(scratch / "set", design, sheet(), options);
  ASSERT_FALSE(done);
  EXPECT_NE(problem_of(done).find("300 colours"), std::string::npos) << problem_of(done);
  EXPECT_FALSE(fs::exists(scratch / "set"));
}

TEST(RecolourOptions, ManyColoursHaveAnIndexWithoutShares) {
  EXPECT_EQ(recolour_images(3).size(), 4u);
  EXPECT_EQ(recolour_images(4).size(), 5u);
  EXPECT_EQ(recolour_images(13).size(), 3u);
}

}  // namespace
}  // namespace weftlight::texture_set
