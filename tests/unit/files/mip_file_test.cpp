#include "files/mip_file.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <fstream>

#include "../scratch.h"

namespace weftlight::files {

using base::problem_of;

namespace {

Image level_of(int width, int height, int channels, int k) {
  Image image{width, height, channels, {}};
  for (int i = 0; i < width * height * channels; ++i)
    image.texels.push_back(static_cast<float>((i * 37 + 11 * k) % 256) / 255.0f);
  return image;
}

/// Writes all levels. Returns an error, or an empty string.
std::string write(const std::string& path, MipFormat format, int width, int height, int channels, bool srgb) {
  const auto file = MipFile::open(path, format, width, height, channels, srgb);
  if (!file) return problem_of(file);
  base::Result<void> added;
  for (int k = 0; added && k < (*file)->levels(); ++k)
    added = (*file)->add(k, level_of(std::max(width >> k, 1), std::max(height >> k, 1), channels, k));
  return problem_of(added ? (*file)->close() : added);
}

class Containers : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Channels, Containers, testing::Values(1, 3, 4));

TEST_P(Containers, OpenImageIoReadsEveryLevelOfADds) {
  const Scratch scratch("dds");
  const std::string path = scratch / "x.dds";
  ASSERT_EQ(write(path, MipFormat::kDds, 32, 8, GetParam(), false), "");
  for (int k = 0; k < 6; ++k) {
    const base::Result<Image> read = read_image(path, k);
    ASSERT_TRUE(read) << problem_of(read);
    const Image wanted = level_of(std::max(32 >> k, 1), std::max(8 >> k, 1), GetParam(), k);
    ASSERT_EQ(read->width, wanted.width);
    ASSERT_EQ(read->height, wanted.height);
    for (int i = 0; i < wanted.width * wanted.height; ++i) {
      for (int c = 0; c < GetParam(); ++c)
        EXPECT_NEAR(read->texels[static_cast<size_t>(i * read->channels + c)],
                    wanted.texels[static_cast<size_t>(i * GetParam() + c)], 1e-3f)
            << "level " << k;
    }
  }
}

/// A picture that blocks can hold: shades of one colour.
Image shades(int width, int height, int channels) {
  Image image{width, height, channels, {}};
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      for (int c = 0; c < channels; ++c)
        image.texels.push_back(c == 3 ? 1.0f
                                      : (0.3f + 0.2f * static_cast<float>(c)) *
                                            (0.6f + 0.4f * std::sin(0.3f * static_cast<float>(x + 2 * y))));
  return image;
}

class Blocks : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Channels, Blocks, testing::Values(1, 2, 3, 4));

TEST_P(Blocks, OpenImageIoReadsEveryLevelOfADds) {
  const Scratch scratch("dds-bc");
  const std::string path = scratch / "x.dds";
  const int channels = GetParam();
  const auto file = MipFile::open(path, MipFormat::kDdsBlocks, 64, 16, channels, false);
  ASSERT_TRUE(file) << problem_of(file);
  for (int k = 0; k < (*file)->levels(); ++k) {
    const Image level = shades(std::max(64 >> k, 1), std::max(16 >> k, 1), channels);
    const int rows = std::min(level.height, 3);  // bands that are no whole rows of blocks
    for (int y = 0; y < level.height; y += rows) {
      const int count = std::min(rows, level.height - y);
      const auto at = level.texels.begin() + static_cast<std::ptrdiff_t>(y) * level.width * channels;
      ASSERT_TRUE((*file)->add(
          k, {level.width, count, channels, {at, at + static_cast<std::ptrdiff_t>(count) * level.width * channels}}));
    }
  }
  ASSERT_TRUE((*file)->close());
  for (int k = 0; k < (*file)->levels(); ++k) {
    const base::Result<Image> read = read_image(path, k);
    ASSERT_TRUE(read) << problem_of(read);
    const Image wanted = shades(std::max(64 >> k, 1), std::max(16 >> k, 1), channels);
    ASSERT_EQ(read->width, wanted.width);
    ASSERT_EQ(read->height, wanted.height);
    for (int i = 0; i < wanted.width * wanted.height; ++i)
      for (int c = 0; c < channels; ++c)
        EXPECT_NEAR(read->texels[static_cast<size_t>(i * read->channels + c)],
                    wanted.texels[static_cast<size_t>(i * channels + c)],
                    0.03f)  // a fourteenth of the range, and a step
            << "level " << k;
  }
}

uint64_t number_at(const std::string& bytes, size_t at, size_t size) {
  uint64_t out = 0;
  std::memcpy(&out, bytes.data() + at, size);
  return out;
}

TEST_P(Blocks, AKtx2FollowsItsSpecification) {
  const Scratch scratch("ktx2-bc");
  const std::string path = scratch / "x.ktx2";
  const int channels = GetParam();
  const bool color = channels > 2;
  ASSERT_EQ(write(path, MipFormat::kKtx2Blocks, 32, 8, channels, color), "");
  std::ifstream in(path, std::ios::binary);
  const std::string b(std::istreambuf_iterator<char>(in), {});
  // VK_FORMAT_BC4_UNORM_BLOCK, BC5_UNORM_BLOCK, BC7_SRGB_BLOCK
  EXPECT_EQ(number_at(b, 12, 4), channels == 1 ? 139u : channels == 2 ? 141u : 146u);
  const uint64_t descriptor = number_at(b, 48, 4), samples = channels == 2 ? 2 : 1;
  EXPECT_EQ(number_at(b, descriptor, 4), 4u + 24u + 16u * samples);
  EXPECT_EQ(number_at(b, descriptor + 12, 1), channels == 1 ? 131u : channels == 2 ? 132u : 134u);  // colour model
  EXPECT_EQ(number_at(b, descriptor + 16, 4), 0x0303u) << "blocks of 4 x 4";
  const uint64_t unit = channels == 1 ? 8 : 16;
  EXPECT_EQ(number_at(b, descriptor + 20, 1), unit);
  uint64_t before = b.size();
  for (size_t k = 0; k < 6; ++k) {
    const uint64_t offset = number_at(b, 80 + 24 * k, 8), size = number_at(b, 88 + 24 * k, 8);
    const auto blocks = [k](uint64_t side) { return (std::max<uint64_t>(side >> k, 1) + 3) / 4; };
    EXPECT_EQ(size, blocks(32) * blocks(8) * unit);
    EXPECT_EQ(offset % unit, 0u);
    EXPECT_LE(offset + size, before) << "smaller levels come first";
    before = offset;
  }
}

TEST_P(Containers, AKtx2FollowsItsSpecification) {
  const Scratch scratch("ktx2");
  const std::string path = scratch / "x.ktx2";
  const int channels = GetParam(), stored = channels == 1 ? 1 : 4;
  ASSERT_EQ(write(path, MipFormat::kKtx2, 32, 8, channels, channels > 1), "");
  std::ifstream in(path, std::ios::binary);
  const std::string b(std::istreambuf_iterator<char>(in), {});
  EXPECT_EQ(b.substr(0, 12), std::string("\xABKTX 20\xBB\r\n\x1A\n"));
  EXPECT_EQ(number_at(b, 12, 4), channels == 1 ? 9u : 43u);  // VK_FORMAT_R8_UNORM, VK_FORMAT_R8G8B8A8_SRGB
  EXPECT_EQ(number_at(b, 20, 4), 32u);
  EXPECT_EQ(number_at(b, 24, 4), 8u);
  ASSERT_EQ(number_at(b, 40, 4), 6u);
  const uint64_t descriptor = number_at(b, 48, 4), length = number_at(b, 52, 4);
  EXPECT_EQ(descriptor, 80u + 6 * 24u);
  EXPECT_EQ(number_at(b, descriptor, 4), length);
  EXPECT_EQ(length, 4u + 24u + 16u * static_cast<uint64_t>(stored));
  uint64_t before = b.size();
  for (size_t k = 0; k < 6; ++k) {
    const uint64_t offset = number_at(b, 80 + 24 * k, 8), size = number_at(b, 88 + 24 * k, 8);
    const Image wanted = level_of(std::max(32 >> k, 1), std::max(8 >> k, 1), channels, static_cast<int>(k));
    ASSERT_EQ(size, static_cast<uint64_t>(wanted.width * wanted.height * stored));
    EXPECT_EQ(offset % 4, 0u);
    ASSERT_LE(offset + size, before) << "the smallest level comes first";
    before = offset;
    for (int i = 0; i < wanted.width * wanted.height; ++i) {
      for (int c = 0; c < stored; ++c) {
        const auto byte = static_cast<float>(static_cast<uint8_t>(b[offset + static_cast<uint64_t>(i * stored + c)]));
        EXPECT_NEAR(byte, c < channels ? 255 * wanted.texels[static_cast<size_t>(i * channels + c)] : 255.0f, 0.51f);
      }
    }
  }
}

TEST(MipFile, ReportsErrors) {
  const Scratch scratch("mip-wrong");
  EXPECT_NE(problem_of(MipFile::open(scratch / "x.dds", MipFormat::kDds, 0, 8, 4, false)), "");
  EXPECT_NE(problem_of(MipFile::open(scratch / "none/x.dds", MipFormat::kDds, 8, 8, 4, false)), "");
  const auto file = MipFile::open(scratch / "x.dds", MipFormat::kDds, 8, 8, 4, false);
  ASSERT_TRUE(file);
  EXPECT_NE(problem_of((*file)->add(1, level_of(8, 8, 4, 0))), "");
  EXPECT_NE(problem_of((*file)->add(9, level_of(1, 1, 4, 0))), "");
  EXPECT_NE(problem_of((*file)->close()), "") << "no level is complete";
}

}  // namespace
}  // namespace weftlight::files
