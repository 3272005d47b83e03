#pragma once
// Small plain weaves in colours whose channels are at their ends: black, white, pure red, green, blue and what is near.

#include <array>
#include <string>

#include "design/yarn_presets.h"
#include "designs.h"

namespace weftlight::render_data {

using design::Design, design::Yarn, design::yarn_presets;
using draft::Rgb, draft::Threads;

inline constexpr float kPureSpacing = 0.5f;  // mm

/// So many of 255.
inline Rgb of_255(int r, int g, int b) {
  return {static_cast<float>(r) / 255, static_cast<float>(g) / 255, static_cast<float>(b) / 255};
}

struct ColourPair {
  const char* name;
  Rgb warp, weft;
};
inline const std::array<ColourPair, 7> kPurePairs{{{"black, white", of_255(0, 0, 0), of_255(255, 255, 255)},
                                                   {"red, white", of_255(255, 0, 0), of_255(255, 255, 255)},
                                                   {"green, black", of_255(0, 255, 0), of_255(0, 0, 0)},
                                                   {"violet, black", of_255(0x33, 0, 255), of_255(0, 0, 0)},
                                                   {"red, green", of_255(255, 0, 0), of_255(0, 255, 0)},
                                                   {"blue, blue", of_255(0, 0, 255), of_255(0, 0, 255)},
                                                   {"black, black", of_255(0, 0, 0), of_255(0, 0, 0)}}};

/// Four ends and picks.
inline Design plain_in(const Rgb& warp, const Rgb& weft, const Yarn& yarn = {}) {
  Design design = twill(2, 1, warp, weft);
  design.yarns[0] = yarn;
  for (Threads* t : {&design.draft.warp, &design.draft.weft}) {
    t->spacing_mm.assign(t->color.size(), kPureSpacing);
    t->thickness_mm.assign(t->color.size(), 0.85f * kPureSpacing);
  }
  return design;
}

/// Every other end in the weft's colour.
inline Design striped_in(const Rgb& warp, const Rgb& weft, const Yarn& yarn = {}) {
  Design design = plain_in(warp, weft, yarn);
  for (size_t i = 0; i < design.draft.warp.color.size(); i += 2) design.draft.warp.color[i] = 1;
  return design;
}

inline Yarn metal_yarn() {
  Yarn yarn;
  yarn.lobes.metallic = true;
  yarn.lobes.fuzz = 0;
  return yarn;
}

inline Yarn yarn_named(const std::string& name) {
  for (const Yarn& yarn : yarn_presets())
    if (yarn.name == name) return yarn;
  return {};
}

}  // namespace weftlight::render_data
