#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <utility>

#include "../scratch.h"
#include "base/loops.h"
#include "base/whole_files.h"
#include "files/files.h"
#include "files/image_rows.h"

namespace weftlight::files {

using base::problem_of, base::write_file_atomically;

namespace {

Image ramp(int width, int height, int channels) {
  Image image{width, height, channels, {}};
  for (int i = 0; i < width * height * channels; ++i)
    image.texels.push_back(static_cast<float>((i * 37) % 256) / 255.0f);
  return image;
}

struct Kind {
  const char* name;
  PixelType type;
  int channels;
  float tolerance;
};

class RoundTrip : public testing::TestWithParam<Kind> {};

TEST_P(RoundTrip, KeepsEveryTexel) {
  const Scratch scratch("image");
  const Kind kind = GetParam();
  const Image out = ramp(19, 7, kind.channels);
  ASSERT_EQ(problem_of(write_image(scratch / kind.name, out, kind.type)), "");
  const base::Result<Image> in = read_image(scratch / kind.name);
  ASSERT_TRUE(in) << problem_of(in);
  ASSERT_EQ(in->width, 19);
  ASSERT_EQ(in->height, 7);
  ASSERT_EQ(in->channels, kind.channels);
  for (size_t i = 0; i < out.texels.size(); ++i) {
    ASSERT_NEAR(in->texels[i], out.texels[i], kind.tolerance) << "texel value " << i;
  }
}

// Colour under alpha 0 must survive, since engines filter it into the neighbours of a gap.
INSTANTIATE_TEST_SUITE_P(
    All, RoundTrip,
    testing::Values(Kind{"grey8.png", PixelType::kU8, 1, 1e-6f}, Kind{"rgb8.png", PixelType::kU8, 3, 1e-6f},
                    Kind{"rgba8.png", PixelType::kU8, 4, 1e-6f}, Kind{"grey16.png", PixelType::kU16, 1, 1e-5f},
                    Kind{"rgba16.png", PixelType::kU16, 4, 1e-5f}, Kind{"half.exr", PixelType::kHalf, 3, 5e-4f},
                    Kind{"half_alpha.exr", PixelType::kHalf, 4, 5e-4f}, Kind{"float.exr", PixelType::kFloat, 1, 0.0f},
                    Kind{"many.exr", PixelType::kHalf, 16, 5e-4f}, Kind{"rgb.tif", PixelType::kU16, 3, 1e-5f},
                    Kind{"rgba.tif", PixelType::kFloat, 4, 0.0f}, Kind{"rgb.jpg", PixelType::kU8, 3, 1.0f}));

TEST(Pictures, AreMadeReadyOnceOrSeveralTimesAtOnce) {
  const Scratch scratch("image");
  base::for_each_job(4, [](int) { load_pictures(); });
  EXPECT_EQ(problem_of(write_image(scratch / "small.png", ramp(4, 4, 3), PixelType::kU8)), "");
}

TEST(Image, RowZeroIsTheTop) {
  const Scratch scratch("top");
  Image image{1, 2, 1, {1.0f, 0.0f}};
  ASSERT_EQ(problem_of(write_image(scratch / "top.png", image, PixelType::kU8)), "");
  EXPECT_EQ(read_image(scratch / "top.png")->texels, image.texels);
}

TEST(Image, OutOfRangeValuesStayFinite) {
  const Scratch scratch("range");
  const float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();
  const Image image{4, 1, 1, {nan, inf, -inf, 1e6f}};
  ASSERT_EQ(problem_of(write_image(scratch / "half.exr", image, PixelType::kHalf)), "");
  EXPECT_EQ(read_image(scratch / "half.exr")->texels, (std::vector<float>{0, 65504, -65504, 65504}));
  ASSERT_EQ(problem_of(write_image(scratch / "u8.png", image, PixelType::kU8)), "");
  EXPECT_EQ(read_image(scratch / "u8.png")->texels, (std::vector<float>{0, 1, 0, 1}));
  ASSERT_EQ(problem_of(write_image(scratch / "u16.png", image, PixelType::kU16)), "");
  EXPECT_EQ(read_image(scratch / "u16.png")->texels, (std::vector<float>{0, 1, 0, 1}));
  // As many as are computed side by side, and some more.
  Image many{45, 2, 1, {}};
  for (int i = 0; i < 90; ++i) many.texels.push_back(i % 5 == 0 ? nan : i % 5 == 1 ? inf : i % 5 == 2 ? -inf : 0.2f);
  ASSERT_EQ(problem_of(write_image(scratch / "many.png", many, PixelType::kU8)), "");
  const Image back = *read_image(scratch / "many.png");
  for (size_t i = 0; i < 90; ++i) EXPECT_FLOAT_EQ(back.texels[i], i % 5 == 1 ? 1.0f : i % 5 < 3 ? 0.0f : 0.2f) << i;
}

TEST(Image, EncodesPngInMemory) {
  const Scratch scratch("memory");
  const Image image = ramp(8, 8, 4);
  const std::vector<unsigned char> png = encode_png(image);
  ASSERT_EQ(problem_of(
                write_file_atomically(scratch / "memory.png", {reinterpret_cast<const char*>(png.data()), png.size()})),
            "");
  const base::Result<Image> back = read_image(scratch / "memory.png");
  ASSERT_TRUE(back) << problem_of(back);
  for (size_t i = 0; i < image.texels.size(); ++i) ASSERT_NEAR(back->texels[i], image.texels[i], 1e-6f);
}

/// Without a pattern that would pack well.
Image noise(int width, int height, int channels) {
  Image image{width, height, channels, {}};
  uint32_t state = 1;
  for (int i = 0; i < width * height * channels; ++i)
    image.texels.push_back(static_cast<float>((state = state * 1664525u + 1013904223u) >> 16) / 65535.0f);
  return image;
}

/// Rows [first, first + count) of it.
Image band_of(const Image& image, int first, int count) {
  const auto row = static_cast<ptrdiff_t>(image.width) * image.channels;
  return {image.width,
          count,
          image.channels,
          {image.texels.begin() + first * row, image.texels.begin() + (first + count) * row}};
}

TEST(PngRows, BandsGiveTheBytesOfTheWhole) {
  const Scratch scratch("bands");
  for (const PixelType type : {PixelType::kU8, PixelType::kU16}) {
    const Image image = noise(100, 90, 3);  // of several chunks
    const auto rows = ImageRows::open(scratch / "bands.png", 100, 90, 3, type, {});
    ASSERT_TRUE(rows) << problem_of(rows);
    for (const auto& [first, count] : {std::pair(0, 1), std::pair(1, 64), std::pair(65, 25)})
      ASSERT_EQ(problem_of((*rows)->add(band_of(image, first, count))), "");
    ASSERT_EQ(problem_of((*rows)->close()), "");
    const std::vector<unsigned char> whole = encode_png(image, type);
    EXPECT_EQ(base::read_file(scratch / "bands.png"), std::string(whole.begin(), whole.end()));
    const base::Result<Image> back = read_image(scratch / "bands.png");
    ASSERT_TRUE(back) << problem_of(back);
    const float step = type == PixelType::kU8 ? 1.0f / 255 : 1.0f / 65535;
    for (size_t i = 0; i < image.texels.size(); ++i) ASSERT_NEAR(back->texels[i], image.texels[i], 0.51f * step);
  }
}

TEST(PngRows, WrongAndMissingRowsAreErrors) {
  const Scratch scratch("rows");
  const auto rows = ImageRows::open(scratch / "rows.png", 4, 4, 3, PixelType::kU8, {});
  ASSERT_TRUE(rows) << problem_of(rows);
  EXPECT_NE(problem_of((*rows)->add(ramp(5, 1, 3))), "");
  EXPECT_NE(problem_of((*rows)->add(ramp(4, 1, 4))), "");
  EXPECT_NE(problem_of((*rows)->add(ramp(4, 5, 3))), "");
  EXPECT_EQ(problem_of((*rows)->add(ramp(4, 3, 3))), "");
  EXPECT_NE(problem_of((*rows)->close()), "");
  EXPECT_FALSE(ImageRows::open(scratch / "no/such/folder.png", 4, 4, 3, PixelType::kU8, {}));
  EXPECT_FALSE(ImageRows::open(scratch / "many.png", 4, 4, 5, PixelType::kU8, {}));
}

TEST(PngRows, AFullDiskIsAnError) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "this system has no device that is always full";
  const Scratch scratch("full");
  std::filesystem::create_symlink("/dev/full", scratch / "full.png");
  const auto rows = ImageRows::open(scratch / "full.png", 256, 256, 4, PixelType::kU8, {});
  ASSERT_TRUE(rows) << problem_of(rows);
  const base::Result<void> added = (*rows)->add(noise(256, 256, 4));
  const base::Result<void> closed = added ? (*rows)->close() : added;
  EXPECT_NE(problem_of(closed).find("the disk is full"), std::string::npos) << problem_of(closed);
}

TEST(Text, IsInkOnTheBaseLine) {
  Image image{200, 60, 3, std::vector<float>(size_t{200} * 60 * 3, 1.0f)};
  draw_text(image, 10, 40, 30, "H", {0.0f, 0.5f, 1.0f});
  int inked = 0, below = 0;
  for (size_t i = 0; i < image.texels.size(); i += 3) {
    EXPECT_EQ(image.texels[i + 2], 1.0f);
    EXPECT_NEAR(1 - image.texels[i + 1], 0.5f * (1 - image.texels[i]), 1e-6f);
    if (image.texels[i] < 1) ++inked, below += i >= size_t{41} * 200 * 3;
  }
  EXPECT_GT(inked, 50);
  EXPECT_EQ(below, 0);
  draw_text(image, -20, 70, 30, "beyond every edge, to the right as well", {0, 0, 0});
}

TEST(Image, InvalidImagesAreErrors) {
  const Scratch scratch("refuse");
  EXPECT_NE(problem_of(write_image(scratch / "none.png", Image{}, PixelType::kU8)), "");
  EXPECT_NE(problem_of(write_image(scratch / "short.png", Image{4, 4, 3, {0.0f}}, PixelType::kU8)), "");
  EXPECT_NE(problem_of(write_image(scratch / "what.xyz", ramp(2, 2, 3), PixelType::kU8)), "");
  EXPECT_NE(problem_of(write_image(scratch / "no/such/folder.png", ramp(2, 2, 3), PixelType::kU8)), "");
  EXPECT_TRUE(std::filesystem::is_empty(scratch.folder)) << "a failed write left a file";
  EXPECT_NE(problem_of(read_image(scratch / "missing.png")), "");
  std::ofstream(scratch / "text.png") << "this is no image";
  EXPECT_NE(problem_of(read_image(scratch / "text.png")), "");
}

TEST(Image, FailedWriteKeepsTheOldFile) {
  const Scratch scratch("old");
  ASSERT_EQ(problem_of(write_image(scratch / "a.png", ramp(3, 3, 3), PixelType::kU8)), "");
  EXPECT_NE(problem_of(write_image(scratch / "a.png", Image{3, 3, 3, {}}, PixelType::kU8)), "");
  EXPECT_TRUE(read_image(scratch / "a.png"));
}

TEST(Image, TruncatedFilesAreErrors) {
  const Scratch scratch("cut");
  for (const char* name : {"cut.png", "cut.exr"}) {
    ASSERT_EQ(problem_of(write_image(scratch / name, ramp(64, 64, 3), PixelType::kHalf)), "");
    std::filesystem::resize_file(scratch / name, std::filesystem::file_size(scratch / name) / 2);
    EXPECT_FALSE(read_image(scratch / name)) << name;
  }
}

}  // namespace
}  // namespace weftlight::files
