#pragma once
// A picture of a round thread with its twist, grooves and flyaway fibres, shaded on the CPU by the formulas of the
// cloth.

#include <vector>

#include "ui/pixel_texture.h"
#include "views/common/panel.h"

namespace weftlight::views {

using design::Yarn;
using draft::Rgb;
using ui::PixelTexture;

/// width x height pixels, row 0 on top, transparent beside the thread. The light is `light_deg` to the right of the
/// normal and a little above.
std::vector<ImU32> yarn_strip(const Yarn& yarn, Rgb colour, float light_deg, int width, int height);

/// The strip as a texture, shaded again only when its input changes.
class YarnStrip {
 public:
  ImTextureID of(const Yarn& yarn, Rgb colour, float light_deg, int width, int height);

 private:
  struct Key {
    Yarn yarn;
    Rgb colour;
    float light_deg = 0;
    int width = 0, height = 0;
    bool operator==(const Key&) const = default;
  };
  PixelTexture texture_;
  Key key_;
};

}  // namespace weftlight::views
