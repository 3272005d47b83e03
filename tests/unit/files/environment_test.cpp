// Environment maps: what is kept of them, and what is rejected.

#include "files/environment.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "../scratch_fixture.h"

namespace weftlight::files {

using base::problem_of;

namespace {

constexpr double kPi = 3.14159265358979;

using Environments = ScratchTest;

Image grey(int width, int height, float value) {
  return {width, height, 3, std::vector<float>(static_cast<size_t>(3 * width * height), value)};
}

/// Integral of the first channel over the sphere.
double energy(const Image& image) {
  double sum = 0;
  const double step = kPi / image.height;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      sum += (std::cos(y * step) - std::cos((y + 1) * step)) * 2 * kPi / image.width *
             static_cast<double>(image.texels[static_cast<size_t>(3 * (y * image.width + x))]);
  return sum;
}

TEST_F(Environments, LargePicturesAreScaledDownAndKeepTheirLight) {
  Image large = grey(4096, 2048, 0.25f);
  std::minstd_rand random(7);
  for (int i = 0; i < 300; ++i) large.texels[random() % large.texels.size()] = static_cast<float>(random() % 90000);
  for (const char* name : {"large.exr", "large.hdr"}) {
    ASSERT_EQ(problem_of(write_image(path(name), large, PixelType::kFloat)), "");
    const base::Result<EnvironmentPicture> read = read_environment(path(name));
    ASSERT_TRUE(read) << problem_of(read);
    EXPECT_TRUE(read->remarks.empty());
    EXPECT_EQ(read->picture.width, kEnvironmentWidth);
    EXPECT_EQ(read->picture.height, kEnvironmentWidth / 2);
    EXPECT_NEAR(energy(read->picture) / energy(large), 1, 0.004) << name;  // .hdr has eight bits per channel
  }
}

TEST_F(Environments, WhiteStaysWhiteAtAnySize) {
  for (const int width : {4, 64, 1000, 1500, 3000}) {
    ASSERT_EQ(problem_of(write_image(path("white.exr"), grey(width, width / 2, 1), PixelType::kFloat)), "");
    const base::Result<EnvironmentPicture> read = read_environment(path("white.exr"));
    ASSERT_TRUE(read) << problem_of(read);
    for (const float value : read->picture.texels) ASSERT_NEAR(value, 1, 1e-5) << width;
  }
}

TEST_F(Environments, InvalidValuesAreReplacedAndReported) {
  Image odd = grey(64, 32, 0.5f);
  odd.texels[3] = -4, odd.texels[7] = std::nanf(""), odd.texels[11] = -std::numeric_limits<float>::infinity();
  odd.texels[15] = std::numeric_limits<float>::infinity();
  ASSERT_EQ(problem_of(write_image(path("odd.exr"), odd, PixelType::kFloat)), "");
  const base::Result<EnvironmentPicture> read = read_environment(path("odd.exr"));
  ASSERT_TRUE(read) << problem_of(read);
  ASSERT_EQ(read->remarks.size(), 2u);
  EXPECT_NE(read->remarks[0].find("odd.exr: 3 values are below 0 or not numbers"), std::string::npos)
      << read->remarks[0];
  EXPECT_NE(read->remarks[1].find("1 value is above 1e7"), std::string::npos) << read->remarks[1];
  EXPECT_EQ(read->picture.texels[3], 0);
  EXPECT_EQ(read->picture.texels[15], 1e7f);
}

TEST_F(Environments, RefusesWithReasons) {
  const auto refused = [&](const std::string& name, const char* why, bool by_its_header = true) {
    const base::Result<EnvironmentPicture> read = read_environment(path(name));
    EXPECT_FALSE(read);
    EXPECT_NE(problem_of(read).find(name), std::string::npos) << problem_of(read);
    EXPECT_NE(problem_of(read).find(why), std::string::npos) << problem_of(read);
    EXPECT_EQ(problem_of(check_environment(path(name))), by_its_header ? problem_of(read) : "");
  };
  ASSERT_EQ(problem_of(write_image(path("square.exr"), grey(64, 64, 1), PixelType::kFloat)), "");
  ASSERT_EQ(problem_of(write_image(path("flat.png"), grey(64, 32, 1), PixelType::kU8)), "");
  ASSERT_EQ(problem_of(write_image(path("black.exr"), grey(64, 32, 0), PixelType::kFloat)), "");
  ASSERT_EQ(problem_of(write_image(path("tiny.exr"), grey(2, 1, 1), PixelType::kFloat)), "");
  refused("none.hdr", "no such file");
  refused("square.exr", "twice as wide as high");
  refused("flat.png", "give an .hdr or an .exr");
  refused("black.exr", "black everywhere", false);
  refused("tiny.exr", "at least 4 x 2");
  written("words.hdr", "these are words\n");
  refused("words.hdr", "give an undamaged .hdr or .exr");
  // Sizes are checked before memory is allocated.
  written("huge.hdr", "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1000000 +X 2000000\n");
  refused("huge.hdr", "scale it down");
  written("empty.hdr", "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 16384 +X 32768\n");
  refused("empty.hdr", "the file is damaged", false);
  ASSERT_EQ(problem_of(write_image(path("whole.exr"), grey(512, 256, 1), PixelType::kFloat)), "");
  const std::string bytes = base::read_file(path("whole.exr")).value_or("");
  written("half.exr", bytes.substr(0, bytes.size() / 2));
  refused("half.exr", "damaged", false);
}

TEST_F(Environments, RandomlyChangedBytesNeverCrash) {
  std::minstd_rand random(11);
  Image noise = grey(32, 16, 1);
  for (float& v : noise.texels) v = static_cast<float>(random() % 1000) / 250;
  int read_well = 0;
  for (const char* name : {"noise.exr", "noise.hdr"}) {
    ASSERT_EQ(problem_of(write_image(path(name), noise, PixelType::kFloat)), "");
    const std::string whole = base::read_file(path(name)).value_or("");
    for (int round = 0; round < 120; ++round) {
      std::string bytes = whole;
      for (unsigned k = 0; k < 1 + random() % 6; ++k)
        bytes[random() % bytes.size()] = static_cast<char>(random() % 256);
      if (round % 5 == 0) bytes.resize(random() % bytes.size());
      const base::Result<EnvironmentPicture> read = read_environment(written(name, bytes));
      ASSERT_EQ(problem_of(read).empty(), read.has_value());
      if (!read) continue;
      ++read_well;
      for (const float v : read->picture.texels) ASSERT_TRUE(std::isfinite(v) && v >= 0);
    }
  }
  EXPECT_GT(read_well, 20);
}

}  // namespace
}  // namespace weftlight::files
