// The default tile: several centimetres for yarns that vary, at a cost that does not grow with the cloth.
#include "texture_set/tile.h"

#include <gtest/gtest.h>

#include <cmath>

#include "sample_set.h"
#include "texture_set/face_source.h"

namespace weftlight::texture_set {
namespace {

using draft::drawdown;
using weaves::Lean, weaves::twill;

Design slubby() {
  Design design = twill({2, 2}, Lean::kRight, {8, 8});
  Yarn yarn;
  yarn.unevenness = 30;
  design.yarns = {yarn};
  return design;
}

Tile tile_of(const Design& design, float tile_mm, int size) {
  return make_tile(design, drawdown(design.draft), Face::kFront, tile_mm, size);
}

FaceSource face_of(Tile tile, int size) {
  FaceOptions options;
  options.fitted = false;
  options.size = texture_size(tile.cloth.width_mm, tile.cloth.depth_mm, size);
  return {std::move(tile), options};
}

float grey(const SurfaceTexel& t) { return (t.base.r + t.base.g + t.base.b) / 3; }

/// Standard deviation of the mean heights of 8 x 8 blocks, mm: what is left from afar.
double from_afar(const SurfaceTexels& surface) {
  constexpr int kBlocks = 8;
  const int w = surface.texels.width / kBlocks, h = surface.texels.height / kBlocks;
  double sum = 0, squares = 0;
  for (int b = 0; b < kBlocks * kBlocks; ++b) {
    double mean = 0;
    for (int y = 0; y < h; ++y)
      for (int x = 0; x < w; ++x)
        mean += static_cast<double>(surface.texels.at(b % kBlocks * w + x, b / kBlocks * h + y).height_mm);
    mean /= w * h;
    sum += mean, squares += mean * mean;
  }
  const double n = kBlocks * kBlocks;
  return std::sqrt(std::max(squares / n - sum * sum / (n * n), 0.0));
}

TEST(Tile, IsSeveralCentimetresForYarnsThatVary) {
  const Tile tile = tile_of(slubby(), kTileOfYarns, 1024);
  EXPECT_GT(tile.cloth.width_mm, 20);
  EXPECT_LT(tile.cloth.width_mm, 55);
  EXPECT_GE(1024.0f / static_cast<float>(tile.cloth.ends.size()), 6);
  EXPECT_EQ(tile.cloth.ends.size() % 4, 0u);
}

TEST(Tile, KeepsSixTexelsAThread) {
  for (const int size : {16, 64, 256, 512}) {
    const Tile tile = tile_of(slubby(), kTileOfYarns, size);
    if (tile.across == 1) continue;
    EXPECT_GE(static_cast<float>(size) / static_cast<float>(tile.cloth.ends.size()), 6) << size;
  }
}

TEST(Tile, IsOneRepeatForEvenYarns) {
  Design design = slubby();
  design.yarns[0].unevenness = 4;  // a filament
  EXPECT_EQ(tile_of(design, kTileOfYarns, 1024).across, 1);
  design.yarns[0].melange = 0.4f;
  EXPECT_GT(tile_of(design, kTileOfYarns, 1024).across, 1);
}

TEST(Tile, ThatWasAskedForHasThatSize) {
  const Tile tile = tile_of(slubby(), 20, 64);
  EXPECT_GE(tile.cloth.width_mm, 20);
  EXPECT_LT(tile.cloth.width_mm, 22);
  EXPECT_EQ(tile_of(slubby(), 0, 64).across, 1);
}

TEST(Tile, ShowsTheYarnsFromAfar) {
  const FaceSource many = face_of(tile_of(slubby(), 15, 256), 256);
  ASSERT_GT(many.tile().across, 4);
  EXPECT_GT(from_afar(many.rows(0, many.size().height)), 4e-3);
}

TEST(Tile, HasNoSeam) {
  const FaceSource face = face_of(tile_of(slubby(), 40, 256), 256);
  ASSERT_TRUE(face.tile().part.has_value());
  const SurfaceTexels all = face.rows(0, face.size().height);
  const int w = all.texels.width, h = all.texels.height;
  std::vector<double> steps(static_cast<size_t>(w));  // from each column to the next
  for (int x = 0; x < w; ++x)
    for (int y = 0; y < h; ++y) {
      const SurfaceTexel &a = all.texels.at(x, y), &b = all.texels.at((x + 1) % w, y);
      steps[static_cast<size_t>(x)] += static_cast<double>(std::abs(grey(a) * a.occlusion - grey(b) * b.occlusion));
    }
  EXPECT_LE(steps.back(), *std::max_element(steps.begin(), steps.end() - 1));
}

TEST(Tile, OcclusionOfAPartIsNearThatOfTheWhole) {
  Design design = slubby();
  design.yarns[0].unevenness = 15;
  Tile tile = tile_of(design, 40, 256);
  ASSERT_TRUE(tile.part.has_value());
  Tile whole = tile;
  whole.part.reset();
  const FaceSource a = face_of(std::move(tile), 256), b = face_of(std::move(whole), 256);
  const SurfaceTexels rows_a = a.raw_rows(0, 32), rows_b = b.raw_rows(0, 32);
  double squares = 0, mean_a = 0, mean_b = 0;
  const size_t n = rows_a.texels.at_.size();
  for (size_t i = 0; i < n; ++i) {
    const auto x = static_cast<double>(rows_a.texels.at_[i].occlusion),
               y = static_cast<double>(rows_b.texels.at_[i].occlusion);
    squares += (x - y) * (x - y), mean_a += x, mean_b += y;
  }
  // The whole has 13 samples a thread here, the part 20.
  EXPECT_NEAR(mean_a / mean_b, 1, 0.05);
  EXPECT_LT(std::sqrt(squares / static_cast<double>(n)), 0.1);
}

TEST(Tile, DensityChoosesTileAndSize) {
  TextureSetOptions options;
  options.tile_mm = kTileOfYarns;
  set_density(options, slubby(), 100);
  EXPECT_GT(options.tile_mm, 15);
  EXPECT_EQ(options.size, 2048);
  options.tile_mm = 0;
  set_density(options, slubby(), 100);
  EXPECT_LE(options.size, 512);
}

}  // namespace
}  // namespace weftlight::texture_set
