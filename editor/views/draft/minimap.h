#pragma once
// The minimap: the whole drawdown in a corner of its pane, if the pane shows only a part. A frame marks that part;
// click or drag moves it. It comes when the draft is scrolled or zoomed or the pointer is on a scroll bar, and goes
// soon after, so that it hides no cell from the weaver.

#include "ui/pixel_texture.h"
#include "views/common/overview_image.h"
#include "views/draft/draft_context.h"
#include "views/draft/draft_layout.h"

namespace weftlight::views {

using draft::Face;
using ui::PixelTexture;

class Minimap {
 public:
  /// Call before the grids handle the mouse, because it lies above them.
  void apply_input(DraftContext& c, const DraftLayout& layout);
  /// Shows it, because the pointer is on a scroll bar.
  void call() { called_ = true; }
  /// The time at which it goes, by the window's clock; negative if it is not shown.
  double goes_at_s() const { return goes_at_s_; }
  /// Call after the grids are drawn.
  void draw(ImDrawList* dl, const DraftContext& c, const DraftLayout& layout);

 private:
  void follow(const DraftContext& c, const DraftLayout& layout);
  void update(const DraftContext& c, int width, int height);

  /// What the pane shows of which draft.
  struct Part {
    float pitch = 0, end = 0, pick = 0;
    bool operator==(const Part&) const = default;
  };
  Part part_;
  bool called_ = false, wanted_ = false, on_ = false;
  double goes_at_s_ = -1;
  OverviewImage overview_;
  PixelTexture texture_;
  struct Key {
    uint64_t revision = 0;
    Face face = Face::kFront;
    bool structure = false, dark = false;
    int width = 0, height = 0;
    bool operator==(const Key&) const = default;
  };
  Key key_;
};

}  // namespace weftlight::views
