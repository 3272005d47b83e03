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

}  // namespace

float shared_width(const Style& style, float width, bool inspector) {
  return std::max(1.0f, width - (inspector && has_room(style, width, kMinWithInspector) ? style.px(kInspector) : 0.0f));
}

WindowLayout lay_out_window(const Style& style, ImVec2 at, ImVec2 size, float split, WantedPanes wanted) {
  WindowLayout l;
  const float status = std::min(style.px(kStatusBar), std::max(0.0f, size.y)), height = std::max(0.0f, size.y - status);
  l.room = shared_width(style, size.x, wanted.inspector);
  if (wanted.inspector && has_room(style, size.x, kMinWithInspector) && !has_room(style, size.x, kMinForAll))
    wanted.cloth = false;
  const float draft = wanted.cloth ? std::floor(l.room * split) : l.room;
  const float gap = std::min(style.px(kSplitter), std::max(0.0f, l.room - draft));
  l.draft = {at, {draft, height}};
  l.splitter = {{at.x + draft, at.y}, {gap, height}};
  l.cloth = {{at.x + draft + gap, at.y}, {l.room - draft - gap, height}};
  l.inspector = {{at.x + l.room, at.y}, {std::max(0.0f, size.x - l.room), height}};
  l.status = {{at.x, at.y + height}, {std::max(0.0f, size.x), status}};
  return l;
}

}  // namespace weftlight::views
