#include "files/block_compression.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace weftlight::files {
namespace {

using Texels4 = std::array<uint8_t, 64>;
using Texels1 = std::array<uint8_t, 16>;

unsigned bits(const uint8_t* bytes, size_t first, size_t count) {
  unsigned out = 0;
  for (size_t i = 0; i < count; ++i) out |= (bytes[(first + i) / 8] >> (first + i) % 8 & 1u) << i;
  return out;
}

// As the Khronos Data Format describes RGTC1.
Texels1 read_bc4(const Bc4Block& block) {
  Texels1 out{};
  const unsigned a = block[0], b = block[1];
  for (size_t i = 0; i < 16; ++i) {
    const unsigned k = bits(block.data(), 16 + 3 * i, 3);
    unsigned v = k == 0 ? a : b;
    if (k > 1 && a > b) v = ((8 - k) * a + (k - 1) * b + 3) / 7;
    else if (k > 1) v = k == 6 ? 0 : k == 7 ? 255 : ((6 - k) * a + (k - 1) * b + 2) / 5;
    out[i] = static_cast<uint8_t>(v);
  }
  return out;
}

// Mode 6 of BPTC.
Texels4 read_bc7(const Bc7Block& block) {
  constexpr std::array<unsigned, 16> kWeights{0, 4, 9, 13, 17, 21, 26, 30, 34, 38, 43, 47, 51, 55, 60, 64};
  EXPECT_EQ(bits(block.data(), 0, 7), 64u) << "another mode";
  Texels4 out{};
  size_t at = 65;
  for (size_t i = 0; i < 16; ++i) {
    const size_t count = i == 0 ? 3 : 4;
    const unsigned w = kWeights[bits(block.data(), at, count)];
    at += count;
    for (size_t c = 0; c < 4; ++c) {
      const unsigned low = 2 * bits(block.data(), 7 + 14 * c, 7) + bits(block.data(), 63, 1);
      const unsigned high = 2 * bits(block.data(), 14 + 14 * c, 7) + bits(block.data(), 64, 1);
      out[4 * i + c] = static_cast<uint8_t>(((64 - w) * low + w * high + 32) >> 6);
    }
  }
  return out;
}

int worst(const Texels4& a, const Texels4& b) {
  int most = 0;
  for (size_t i = 0; i < a.size(); ++i) most = std::max(most, std::abs(a[i] - b[i]));
  return most;
}

TEST(BlockCompression, OneColourStaysWithinAStepAndOpaque) {
  for (const std::array<int, 4> color :
       {std::array{0, 0, 0, 255}, {255, 255, 255, 255}, {12, 130, 201, 255}, {77, 78, 79, 0}, {1, 254, 128, 100}}) {
    Texels4 texels{};
    for (size_t i = 0; i < texels.size(); ++i) texels[i] = static_cast<uint8_t>(color[i % 4]);
    const Texels4 read = read_bc7(compress_bc7(texels));
    EXPECT_LE(worst(read, texels), 1) << color[0];
    if (color[3] == 255) {
      EXPECT_EQ(read[3], 255);
    }
  }
}

TEST(BlockCompression, TwoColoursOfThreadsStayApart) {
  Texels4 texels{};
  for (size_t i = 0; i < 16; ++i) {
    const bool warp = i % 4 < 2;
    const std::array<int, 4> color = warp ? std::array{190, 30, 40, 255} : std::array{25, 60, 170, 255};
    for (size_t c = 0; c < 4; ++c) texels[4 * i + c] = static_cast<uint8_t>(color[c]);
  }
  EXPECT_LE(worst(read_bc7(compress_bc7(texels)), texels), 1);
}

TEST(BlockCompression, AShadedThreadKeepsItsShadesWithinTwoPercent) {
  std::mt19937 random(1);
  std::uniform_int_distribution<int> any(0, 255);
  double sum = 0;
  constexpr int kBlocks = 200;
  for (int block = 0; block < kBlocks; ++block) {
    const std::array<int, 3> color{any(random), any(random), any(random)};
    Texels4 texels{};
    for (size_t i = 0; i < 16; ++i) {
      const float shade = 0.4f + 0.6f * std::sin(0.2f * static_cast<float>(i % 4) + 0.5f * static_cast<float>(i / 4));
      for (size_t c = 0; c < 3; ++c) texels[4 * i + c] = static_cast<uint8_t>(static_cast<float>(color[c]) * shade);
      texels[4 * i + 3] = 255;
    }
    const Texels4 read = read_bc7(compress_bc7(texels));
    for (size_t i = 0; i < texels.size(); ++i) sum += std::pow(read[i] - texels[i], 2);
  }
  const double rms = std::sqrt(sum / (kBlocks * 48.0));
  RecordProperty("rms", std::to_string(rms));
  EXPECT_LT(rms, 0.02 * 255);
}

TEST(BlockCompression, WhateverIsInABlockIsNoWorseThanItsMean) {
  std::mt19937 random(2);
  std::uniform_int_distribution<int> any(0, 255);
  for (int block = 0; block < 200; ++block) {
    Texels4 texels{};
    std::array<double, 4> mean{};
    for (size_t i = 0; i < texels.size(); ++i)
      texels[i] = static_cast<uint8_t>(any(random)), mean[i % 4] += texels[i] / 16.0;
    const Texels4 read = read_bc7(compress_bc7(texels));
    double off = 0, spread = 0;
    for (size_t i = 0; i < texels.size(); ++i)
      off += std::pow(read[i] - texels[i], 2), spread += std::pow(texels[i] - mean[i % 4], 2);
    EXPECT_LT(off, spread);
  }
}

TEST(BlockCompression, OneChannelIsWithinAFourteenthOfItsRange) {
  std::mt19937 random(3);
  std::uniform_int_distribution<int> any(0, 255);
  for (int block = 0; block < 500; ++block) {
    const int low = any(random), high = any(random);
    std::uniform_int_distribution<int> within(std::min(low, high), std::max(low, high));
    Texels1 texels{};
    for (uint8_t& t : texels) t = static_cast<uint8_t>(within(random));
    const Texels1 read = read_bc4(compress_bc4(texels));
    const auto [least, most] = std::ranges::minmax(texels);
    for (size_t i = 0; i < 16; ++i) EXPECT_LE(std::abs(read[i] - texels[i]), (most - least) / 14.0 + 1);
  }
}

}  // namespace
}  // namespace weftlight::files
