#include "views/shell/window_layout.h"

#include <algorithm>
#include <cmath>

namespace weftlight::views {
namespace {

// Pixels at 96 dpi.
constexpr float kInspector = 316, kStatusBar = 28, kSplitter = 6;
constexpr float kMinForAll = 760;         // width of the window below which the inspector has the place of the cloth
constexpr float kMinWithInspector = 430;  // below which the inspector has no place at all

bool has_room(const Style& style, float width, float least) { return width >= style.px(least); }

void lay_out_side_by_side(WindowLayout& l, const Style& style, ImVec2 at, ImVec2 size, float split,
                          WantedPanes wanted) {
  l.room = shared_width(style, size.x, wanted.inspector);
  if (wanted.inspector && has_room(style, size.x, kMinWithInspector) && !has_room(style, size.x, kMinForAll))
    wanted.cloth = false;
  const float draft = wanted.cloth ? std::floor(l.room * split) : l.room;
  const float gap = std::min(style.pressed_px(kSplitter), std::max(0.0f, l.room - draft));
  l.draft = {at, {draft, size.y}};
  l.splitter = {{at.x + draft, at.y}, {gap, size.y}};
  l.cloth = {{at.x + draft + gap, at.y}, {l.room - draft - gap, size.y}};
  l.inspector = {{at.x + l.room, at.y}, {std::max(0.0f, size.x - l.room), size.y}};
}

void lay_out_stacked(WindowLayout& l, const Style& style, ImVec2 at, ImVec2 size, float split, WantedPanes wanted) {
  l.room = std::max(1.0f, size.y);
  const bool both = has_room(style, size.x, 2 * kInspector);
  if (wanted.inspector && !both) wanted.cloth = false;
  const float draft = wanted.cloth || wanted.inspector ? std::floor(size.y * split) : size.y;
  const float gap = std::min(style.pressed_px(kSplitter), std::max(0.0f, size.y - draft));
  const float below = at.y + draft + gap, high = size.y - draft - gap;
  const float cloth = !wanted.cloth ? 0 : size.x - (wanted.inspector ? style.px(kInspector) : 0);
  l.draft = {at, {size.x, draft}};
  l.splitter = {{at.x, at.y + draft}, {size.x, gap}};
  l.cloth = {{at.x, below}, {cloth, high}};
  l.inspector = {{at.x + cloth, below}, {size.x - cloth, high}};
}

}  // namespace

bool is_stacked(const Style& style, ImVec2 size) { return style.finger > 0 && size.y > size.x; }

float shared_width(const Style& style, float width, bool inspector) {
  return std::max(1.0f, width - (inspector && has_room(style, width, kMinWithInspector) ? style.px(kInspector) : 0.0f));
}

WindowLayout lay_out_window(const Style& style, ImVec2 at, ImVec2 size, float split, WantedPanes wanted) {
  WindowLayout l;
  l.stacked = is_stacked(style, size);
  size.x = std::max(0.0f, size.x);
  const float status = std::min(style.pressed_px(kStatusBar), std::max(0.0f, size.y));
  const float height = std::max(0.0f, size.y - status);
  if (l.stacked) lay_out_stacked(l, style, at, {size.x, height}, split, wanted);
  else lay_out_side_by_side(l, style, at, {size.x, height}, split, wanted);
  l.status = {{at.x, at.y + height}, {size.x, status}};
  return l;
}

}  // namespace weftlight::views
