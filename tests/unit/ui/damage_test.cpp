#include "ui/damage.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace weftlight::ui {
namespace {

constexpr int kSide = 200;

struct Box {
  int x0, y0, x1, y1;
  ImU32 color;
};

/// Frames of plain boxes in one window, as ImGui hands them over.
class DamageTest : public testing::Test {
 protected:
  DamageTest() {
    ImGui::CreateContext();
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.DisplaySize = {kSide, kSide};
    unsigned char* pixels = nullptr;
    int width = 0, height = 0;
    io.Fonts->GetTexDataAsRGBA32(&pixels, &width, &height);
  }
  ~DamageTest() override { ImGui::DestroyContext(); }

  std::vector<Area> frame(const std::vector<Box>& boxes, ImTextureID picture = nullptr, bool second_window = false) {
    ImGui::GetIO().DeltaTime = 0.01f;
    ImGui::NewFrame();
    ImDrawList* dl = ImGui::GetBackgroundDrawList();
    for (const Box& b : boxes)
      dl->AddRectFilled({static_cast<float>(b.x0), static_cast<float>(b.y0)},
                        {static_cast<float>(b.x1), static_cast<float>(b.y1)}, b.color);
    if (picture != nullptr) dl->AddImage(picture, {150, 150}, {180, 190});
    if (second_window) ImGui::GetForegroundDrawList()->AddRectFilled({10, 10}, {20, 20}, IM_COL32_WHITE);
    ImGui::Render();
    return damage.of(*ImGui::GetDrawData());
  }
  Damage damage;
};

const Area kAll{0, 0, kSide, kSide};

bool holds(const std::vector<Area>& areas, float x, float y) {
  return std::any_of(areas.begin(), areas.end(),
                     [&](const Area& a) { return x >= a.x0 && x < a.x1 && y >= a.y0 && y < a.y1; });
}

TEST_F(DamageTest, TheFirstFrameIsDrawnWholeAndTheSameAgainNotAtAll) {
  const std::vector<Box> boxes{{10, 10, 40, 40, IM_COL32(255, 0, 0, 255)}};
  EXPECT_EQ(frame(boxes), std::vector<Area>{kAll});
  EXPECT_TRUE(frame(boxes).empty());
  damage.forget();
  EXPECT_EQ(frame(boxes), std::vector<Area>{kAll});
}

TEST_F(DamageTest, OneCellOfManyIsASmallArea) {
  std::vector<Box> cells;
  for (int y = 0; y < 40; ++y)
    for (int x = 0; x < 40; ++x) cells.push_back({5 * x, 5 * y, 5 * x + 4, 5 * y + 4, IM_COL32(200, 200, 200, 255)});
  frame(cells);
  cells[40 * 7 + 9].color = IM_COL32(0, 0, 0, 255);
  const std::vector<Area> areas = frame(cells);
  ASSERT_EQ(areas.size(), 1u);
  EXPECT_TRUE(holds(areas, 46, 36));
  EXPECT_LE((areas[0].x1 - areas[0].x0) * (areas[0].y1 - areas[0].y0), 64.0f);
}

TEST_F(DamageTest, OtherPixelsOfAPictureAreSeenByItsName) {
  int one = 0, other = 0;
  frame({}, &one);
  EXPECT_TRUE(frame({}, &one).empty());
  EXPECT_TRUE(holds(frame({}, &other), 160, 170));
}

TEST_F(DamageTest, AWindowThatComesOrGoesDrawsAll) {
  frame({});
  EXPECT_EQ(frame({}, nullptr, true), std::vector<Area>{kAll});
  EXPECT_EQ(frame({}), std::vector<Area>{kAll});
}

/// What the boxes paint, last on top.
std::vector<ImU32> painted(const std::vector<Box>& boxes) {
  std::vector<ImU32> pixels(size_t{kSide} * kSide);
  for (const Box& b : boxes)
    for (int y = b.y0; y < b.y1; ++y)
      for (int x = b.x0; x < b.x1; ++x) pixels[static_cast<size_t>(y * kSide + x)] = b.color;
  return pixels;
}

TEST_F(DamageTest, HoldsEveryPixelThatDiffers) {
  std::mt19937 random(7);
  const auto below = [&random](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
  const auto box = [&] {
    const int x = below(kSide - 30), y = below(kSide - 30);
    return Box{x, y, x + 1 + below(29), y + 1 + below(29), IM_COL32(below(255), below(255), below(255), 255)};
  };
  std::vector<Box> boxes(12);
  for (Box& b : boxes) b = box();
  frame(boxes);
  for (int round = 0; round < 300; ++round) {
    const std::vector<ImU32> before = painted(boxes);
    const int kind = below(3);
    const auto at = boxes.begin() + below(static_cast<int>(boxes.size()));
    if (kind == 0) *at = box();
    else if (kind == 1) boxes.insert(at, box());
    else if (boxes.size() > 4) boxes.erase(at);
    const std::vector<Area> areas = frame(boxes);
    ASSERT_LE(areas.size(), Damage::kMaxAreas);
    const std::vector<ImU32> after = painted(boxes);
    for (int y = 0; y < kSide; ++y) {
      for (int x = 0; x < kSide; ++x) {
        const auto i = static_cast<size_t>(y * kSide + x);
        if (before[i] == after[i]) continue;
        ASSERT_TRUE(holds(areas, x + 0.5f, y + 0.5f)) << round << ": " << x << ", " << y;
      }
    }
  }
}

}  // namespace
}  // namespace weftlight::ui
