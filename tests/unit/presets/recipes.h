#pragma once
// Recipes of the shipped drafts. Their output is presets/drafts and presets/yarns; a test compares.

#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

#include "design/design.h"

namespace weftlight::wif {

using design::Design;
using draft::Rgb;

/// The ready yarn as thick and as round as it is spun: the shipped drafts are set close, so that their threads keep it;
/// the cloths have their own thickness.
design::Yarn as_spun(const char* name);

struct PresetRecipe {
  std::string path;  // in presets/
  Design design;
};
std::vector<PresetRecipe> preset_recipes();
/// Only those of presets/cloths.
std::vector<PresetRecipe> cloth_recipes();
/// Five-shaft satin, warp-faced in the figure (flowers in an ogee lattice): 480 ends by 640 picks, without colours.
Design figured_damask();

/// 0xRRGGBB, sRGB as in a palette.
inline Rgb hex(unsigned rgb) {
  const auto channel = [rgb](int shift) { return static_cast<float>((rgb >> shift) & 255u) / 255.0f; };
  return {channel(16), channel(8), channel(0)};
}
inline std::vector<Rgb> palette(std::initializer_list<unsigned> colors) {
  std::vector<Rgb> out;
  for (const unsigned color : colors) out.push_back(hex(color));
  return out;
}
inline Design titled(Design design, std::string title, std::vector<std::string> notes) {
  design.title = std::move(title);
  design.author = "Weftlight";
  design.notes = std::move(notes);
  return design;
}

}  // namespace weftlight::wif
