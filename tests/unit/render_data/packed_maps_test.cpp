#include "render_data/packed_maps.h"

#include <gtest/gtest.h>

#include "designs.h"
#include "render_data/stages.h"

namespace weftlight::render_data {

using cloth::Cloth, cloth::Direction, cloth::Linear, cloth::Maps, cloth::Plane, cloth::Slope, cloth::TexelRect;
using design::Design;
using draft::Face;

namespace {

Maps speckled(int width, int height) {
  Cloth cloth;
  Maps maps;
  maps.width_mm = maps.depth_mm = 1;
  maps.height_mm = Plane<float>(width, height);
  maps.coverage = Plane<float>(width, height);
  maps.colour = Plane<Linear>(width, height, {0.5f, 0.2f, 0.1f});
  maps.groove = Plane<float>(width, height, 1);
  maps.slope = Plane<Slope>(width, height);
  maps.tangent = Plane<Direction>(width, height);
  maps.system = Plane<uint8_t>(width, height);
  maps.thread = Plane<uint32_t>(width, height);
  maps.occlusion = Plane<float>(width, height, 1);
  uint32_t seed = 12345;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      seed = seed * 1664525u + 1013904223u;
      maps.coverage.at(x, y) = (seed >> 28) < 11 ? 1.0f : 0.0f;
      maps.system.at(x, y) = (seed >> 20) & 1;
      maps.slope.at(x, y) = {(seed >> 16) & 1 ? 1.0f : -1.0f, 0};
    }
  }
  return maps;
}

double mean_alpha(const PackedTexture& t, int level) {
  double sum = 0;
  const int w = t.level_width(level), h = t.level_height(level);
  for (int layer = 0; layer < 2; ++layer) {
    for (int y = 0; y < h; ++y) {
      for (int x = 0; x < w; ++x) sum += t.texel(level, layer, x, y)[3];
    }
  }
  return sum / (255.0 * w * h);
}

TEST(PackedMaps, CoverageIsKeptThroughTheMips) {
  const PackedFace face = pack(speckled(128, 64), false);
  const PackedTexture& color = face.textures[0];
  const double finest = mean_alpha(color, 0);
  ASSERT_EQ(color.levels.size(), 8u);
  for (int level = 1; level < 8; ++level) EXPECT_NEAR(mean_alpha(color, level), finest, 0.004) << level;
}

TEST(PackedMaps, SlopesThatTheMipsLoseStayInTheSquares) {
  const PackedFace face = pack(speckled(64, 64), false);
  // Normals at +-45 degrees in equal parts: mean about 0, mean square 1/2, times the coverage.
  const PackedTexture& color = face.textures[0];
  const PackedTexture& relief = face.textures[1];
  const int last = static_cast<int>(relief.levels.size()) - 1;
  for (int layer = 0; layer < 2; ++layer) {
    const float weight = static_cast<float>(color.texel(last, layer, 0, 0)[3]) / 255.0f;
    const float square = static_cast<float>(static_cast<int8_t>(relief.texel(last, layer, 0, 0)[2])) / 127.0f;
    EXPECT_NEAR(square / weight, 0.5f, 0.03f);
  }
}

TEST(PackedMaps, APatchIsThatPartOfTheWhole) {
  Maps maps = speckled(64, 64);
  PackedFace face = pack(maps, false);
  const TexelRect rect{13, 7, 22, 40};
  for (int y = rect.y0; y < rect.y1; ++y) {
    for (int x = rect.x0; x < rect.x1; ++x) {
      maps.coverage.at(x, y) = 1 - maps.coverage.at(x, y);
      maps.colour.at(x, y) = {0.1f, 0.9f, 0.4f};
    }
  }
  const std::vector<PackedPatch> patches = repack(face, Face::kFront, maps, {rect});
  const PackedFace whole = pack(maps, false);
  for (size_t k = 0; k < kPackedKinds; ++k) EXPECT_EQ(face.textures[k].levels, whole.textures[k].levels) << k;
  EXPECT_FALSE(patches.empty());
}

TEST(PackedMaps, BackEqualsTheComplement) {
  const Design design = twill(4, 1, {0.8f, 0.1f, 0.1f}, {0.1f, 0.15f, 0.8f});
  Design other = design;
  for (int pick = 0; pick < other.draft.picks(); ++pick) {
    for (int shaft = 0; shaft < other.draft.shafts; ++shaft) {
      other.draft.liftplan.set(pick, shaft, !design.draft.liftplan.get(pick, shaft));
    }
  }
  Stages a, b;
  a.update(std::make_shared<const Design>(design));
  b.update(std::make_shared<const Design>(other));
  for (size_t k = 0; k < kPackedKinds; ++k) {
    EXPECT_EQ(a.packed().back.textures[k].levels, b.packed().front.textures[k].levels) << k;
  }
}

}  // namespace
}  // namespace weftlight::render_data
