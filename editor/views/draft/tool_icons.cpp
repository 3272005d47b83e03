#include "views/draft/tool_icons.h"

#include <cmath>

namespace weftlight::views {
namespace {

constexpr float kPi = 3.14159265f;

struct Pen {
  ImDrawList* dl;
  ImVec2 middle;
  float half;  // of the icon's width
  ImU32 color;
  float thick;

  /// Coordinates from -1 to 1, y down.
  ImVec2 at(float x, float y) const { return {middle.x + x * half, middle.y + y * half}; }
  void line(ImVec2 a, ImVec2 b) const { dl->AddLine(a, b, color, thick); }
};

/// Points to the lower left.
void draw_pencil(const Pen& p) {
  const ImVec2 body[] = {p.at(-0.62f, 0.22f), p.at(0.42f, -0.82f), p.at(0.82f, -0.42f), p.at(-0.22f, 0.62f)};
  p.dl->AddConvexPolyFilled(body, 4, p.color);
  p.dl->AddTriangleFilled(p.at(-0.72f, 0.36f), p.at(-0.36f, 0.72f), p.at(-0.92f, 0.92f), p.color);
}

void draw_dashed_square(const Pen& p) {
  constexpr float kSide = 0.8f, kDash = 0.36f;
  for (const float side : {-kSide, kSide})
    for (float t = -kSide; t < kSide - 0.01f; t += 0.62f) {
      p.line(p.at(t, side), p.at(t + kDash, side));
      p.line(p.at(side, t), p.at(side, t + kDash));
    }
}

/// A drop of paint.
void draw_drop(const Pen& p) {
  constexpr float kDown = 0.28f, kRadius = 0.62f;
  p.dl->PathLineTo(p.at(0, -0.95f));
  p.dl->PathArcTo(p.at(0, kDown), kRadius * p.half, -0.18f * kPi, 1.18f * kPi, 20);
  p.dl->PathFillConvex(p.color);
}

}  // namespace

void draw_tool_icon(ImDrawList* dl, Tool tool, ImVec2 middle, float size, ImU32 color) {
  const Pen p{dl, {std::floor(middle.x) + 0.5f, std::floor(middle.y) + 0.5f}, size / 2, color, std::round(size / 9)};
  switch (tool) {
    case Tool::kPaint:
      return draw_pencil(p);
    case Tool::kSelect:
      return draw_dashed_square(p);
    case Tool::kLine:
      dl->AddCircleFilled(p.at(-0.75f, 0.75f), p.thick * 1.5f, color);
      dl->AddCircleFilled(p.at(0.75f, -0.75f), p.thick * 1.5f, color);
      return p.line(p.at(-0.75f, 0.75f), p.at(0.75f, -0.75f));
    case Tool::kRectangle:
      return dl->AddRect(p.at(-0.85f, -0.65f), p.at(0.85f, 0.65f), color, 0, 0, p.thick);
    case Tool::kFilledRectangle:
      return dl->AddRectFilled(p.at(-0.85f, -0.65f), p.at(0.85f, 0.65f), color);
    case Tool::kFill:
      return draw_drop(p);
    case Tool::kType:
      // A cell with a caret in it.
      dl->AddRect(p.at(-0.9f, -0.7f), p.at(0.9f, 0.7f), color, size / 8, 0, p.thick * 0.75f);
      p.line(p.at(-0.45f, -0.35f), p.at(-0.45f, 0.35f));
      dl->AddCircleFilled(p.at(0.05f, 0.28f), p.thick * 0.6f, color);
      return dl->AddCircleFilled(p.at(0.45f, 0.28f), p.thick * 0.6f, color);
  }
}

void draw_mirror_icon(ImDrawList* dl, bool across, ImVec2 middle, float size, ImU32 color) {
  const Pen p{dl, {std::floor(middle.x) + 0.5f, std::floor(middle.y) + 0.5f}, size / 2, color, std::round(size / 9)};
  const auto at = [&](float along, float aside) { return across ? p.at(along, aside) : p.at(aside, along); };
  dl->AddTriangleFilled(at(-0.25f, -0.6f), at(-0.25f, 0.6f), at(-0.95f, 0.6f), color);
  dl->AddTriangle(at(0.3f, -0.6f), at(0.3f, 0.6f), at(0.95f, 0.6f), color, std::max(1.0f, p.thick * 0.7f));
  p.line(at(0, -0.95f), at(0, 0.95f));
}

}  // namespace weftlight::views
