#include "views/dialogs/weave_preview.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "draft/drawdown.h"
#include "views/common/cell_image.h"
#include "views/common/overview_image.h"

namespace weftlight::views {

using draft::kMaxThreads;

using weaves::GeneratedWeave;

namespace {

constexpr float kLargestCell = 8;  // pixels at 96 dpi
constexpr int kGapsFrom = 4;       // pixels a cell from which gaps tell warp from weft of the same colour

/// Of the threads on top at (x, y) of the picture, with a gap of one pixel along the upper one.
CellImage cells_as_pixels(const Design& design, const ShownWeave& shown, int width, int height, ImU32 line) {
  const BitMatrix cells = drawdown(design.draft);
  const CrossingColors colors = crossing_colors(design);
  const int cell = static_cast<int>(shown.cell);
  CellImage out{width, height, std::vector<ImU32>(static_cast<size_t>(width) * static_cast<size_t>(height), line)};
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const int end = std::min(x / cell, shown.ends - 1), pick = std::min(y / cell, shown.picks - 1);
      const bool up = warp_on_top(cells, Face::kFront, end, pick);
      if (cell >= kGapsFrom && (up ? x : y) % cell == cell - 1) continue;
      out.pixels[static_cast<size_t>(y) * static_cast<size_t>(width) + static_cast<size_t>(x)] =
          up ? colors.of(System::kWarp, end, pick) : colors.of(System::kWeft, pick, end);
    }
  return out;
}

CellImage reduced(const Design& design, const ShownWeave& shown, int width, int height) {
  OverviewImage overview;
  overview.update(drawdown(design.draft), true, crossing_colors(design), std::min(width, shown.ends),
                  std::min(height, shown.picks));
  return overview.image();
}

void mirror(CellImage& image, bool ends, bool picks) {
  for (int y = 0; y < image.height && ends; ++y) {
    const auto row = image.pixels.begin() + static_cast<std::ptrdiff_t>(y) * image.width;
    std::reverse(row, row + image.width);
  }
  for (int y = 0; y < image.height / 2 && picks; ++y)
    std::swap_ranges(image.pixels.begin() + static_cast<std::ptrdiff_t>(y) * image.width,
                     image.pixels.begin() + static_cast<std::ptrdiff_t>(y + 1) * image.width,
                     image.pixels.begin() + static_cast<std::ptrdiff_t>(image.height - 1 - y) * image.width);
}

}  // namespace

ShownWeave shown_weave(ClothSize repeat, float width, float height, float largest) {
  const auto room = [](float pixels, int threads) { return pixels / static_cast<float>(std::max(1, threads)); };
  float cell = std::min({largest, room(width, repeat.ends), room(height, repeat.picks)});
  if (cell >= 1) cell = std::floor(cell);
  const auto threads = [cell](float pixels) {
    return std::clamp(static_cast<int>(std::ceil(pixels / cell)), 1, kMaxThreads);
  };
  return {threads(width), threads(height), cell};
}

void WeavePreview::make(const Key& key, ClothSize repeat, float largest, ImU32 line) {
  key_ = key;
  const ShownWeave shown = shown_weave(repeat, key.width, key.height, largest);
  GeneratedWeave made = new_draft(*key.kind, key.values, {shown.ends, shown.picks});
  note_ = std::move(made.note);
  shafts_ = made.design.draft.shafts, treadles_ = made.design.draft.treadles;
  const int width = static_cast<int>(key.width), height = static_cast<int>(key.height);
  CellImage image = shown.cell >= 1 ? cells_as_pixels(made.design, shown, width, height, line)
                                    : reduced(made.design, shown, width, height);
  mirror(image, key.end1_right, key.pick1_bottom);
  texture_.set(image.width, image.height, image.pixels);
}

void WeavePreview::draw(PanelContext& c, const WeaveKind& kind, const WeaveValues& values, ClothSize repeat,
                        float width, float height) {
  const Settings& s = c.settings;
  const Key now{&kind, values, std::floor(width), std::floor(height), s.end1_right, s.pick1_bottom, c.style.dark};
  // What is refused keeps the picture before it.
  if (!(now == key_) && (texture_.empty() || check_values(kind, values)))
    make(now, repeat, c.style.px(kLargestCell), c.style.color.line_strong);
  const ImVec2 at = ImGui::GetCursorScreenPos(), end{at.x + now.width, at.y + now.height};
  ImGui::GetWindowDrawList()->AddImage(texture_.id(), at, end);
  ImGui::GetWindowDrawList()->AddRect(at, end, c.style.color.line);
  ImGui::Dummy({now.width, now.height});
}

}  // namespace weftlight::views
