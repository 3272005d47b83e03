#pragma once
// Finds where a frame of the window differs from the previous one, so that only those areas are redrawn. Without a
// graphics card, filling the window's pixels takes ten times as long as building the frame.

#include <imgui.h>

#include <string>
#include <vector>

namespace weftlight::ui {

/// In ImGui's units, half-open.
struct Area {
  float x0 = 0, y0 = 0, x1 = 0, y1 = 0;
  bool empty() const { return x0 >= x1 || y0 >= y1; }
  bool operator==(const Area&) const = default;
};

class Damage {
 public:
  static constexpr size_t kMaxAreas = 6;

  /// Areas, on whole units, that cover every change since the previous frame; none if nothing changed. The first frame
  /// and a frame of another size are one area. A texture whose pixels change must get another name.
  std::vector<Area> changed_areas(const ImDrawData& data);
  /// The next frame is redrawn completely.
  void invalidate() { redraw_all_ = true; }

 private:
  struct Triangle {
    ImDrawVert corner[3];
    ImVec4 clip;
    ImTextureID texture;
  };
  struct List {
    std::string owner;
    std::vector<Triangle> triangles;
  };
  static List list_of(const ImDrawList& from);
  static void compare(const List& before, const List& now, std::vector<Area>& areas);

  std::vector<List> before_;
  ImVec2 size_{0, 0};
  bool redraw_all_ = true;
};

}  // namespace weftlight::ui
