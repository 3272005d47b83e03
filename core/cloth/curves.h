#pragma once
// A patch of cloth as curves, for programs that draw hair: a value between what makes them (core/reference) and what
// writes them (core/files).

#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "cloth/cloth.h"

namespace weftlight::cloth {

/// Curves of one system and one yarn. Millimetres; x along the weft, y along the warp, z towards the viewer of the
/// front.
struct CurveGroup {
  std::string name;        // such as "Warp_1": letters, digits and underscores, a letter first
  float ior = 1.5f;        // of the fibres
  float roughness = 0.5f;  // of the highlight across the thread, 0 to 1
  bool metallic = false;
  float turns_per_m = 0;          // of the yarn's last twist; positive: Z
  std::vector<int> points_in;     // by curve
  std::vector<Linear> colour;     // by curve
  std::vector<int> thread;        // by curve: its end or pick in the draft's repeat, from 1
  std::vector<glm::vec4> points;  // of all curves; w: diameter
};

struct Curves {
  glm::vec2 size_mm{0};
  std::vector<CurveGroup> groups;
};

}  // namespace weftlight::cloth
