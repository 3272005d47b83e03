#pragma once
// Where a frame of the window differs from the one before, so that only that is drawn again: without a graphics card,
// filling the window's pixels takes ten times as long as working out what stands in it.

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

  /// Areas, on whole units, that hold all that is drawn otherwise than in the frame before; none where nothing is. The
  /// first frame, and one of another size, is drawn whole. A texture whose pixels change must change its name.
  std::vector<Area> of(const ImDrawData& data);
  /// The next frame is drawn whole.
  void forget() { whole_ = true; }

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
  bool whole_ = true;
};

}  // namespace weftlight::ui
