#pragma once
// The drawdown of a weave as a small picture that shows a whole repeat, in cells as large as there is room for.

#include <string>

#include "ui/pixel_texture.h"
#include "views/common/panel.h"
#include "weaves/table.h"

namespace weftlight::views {

using ui::PixelTexture;
using weaves::ClothSize, weaves::WeaveKind, weaves::WeaveValues;

/// Half-open numbers of threads, and the pixels of a cell; below 1 the picture is reduced.
struct ShownWeave {
  int ends = 0, picks = 0;
  float cell = 0;
};
/// What a picture of that many pixels shows of a weave: a whole repeat, and as many as fit beside it at `largest`
/// pixels a cell or less. A repeat of 0 is unknown.
ShownWeave shown_weave(ClothSize repeat, float width, float height, float largest);

class WeavePreview {
 public:
  /// Draws it; the weave is made anew if it or the size changed. `width`, `height` in pixels.
  void draw(PanelContext& c, const WeaveKind& kind, const WeaveValues& values, ClothSize repeat, float width,
            float height);
  /// What could not be used as written.
  const std::string& note() const { return note_; }
  /// Of the loom that weaves it.
  int shafts() const { return shafts_; }
  int treadles() const { return treadles_; }

 private:
  struct Key {
    const WeaveKind* kind = nullptr;
    WeaveValues values;
    float width = 0, height = 0;
    bool end1_right = false, pick1_bottom = false, dark = false;
    bool operator==(const Key&) const = default;
  };
  void make(const Key& key, ClothSize repeat, float largest, ImU32 line);

  Key key_;
  std::string note_;
  int shafts_ = 0, treadles_ = 0;
  PixelTexture texture_;
};

}  // namespace weftlight::views
