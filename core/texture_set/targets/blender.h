#pragma once
// What the targets of Blender share: a .glb with the mesh, and a script that builds a material for both faces of it.
// Cycles and EEVEE have a target each, since they show different highlights. Based on: the manual of Blender 3.4 and 4.

#include <glm/glm.hpp>
#include <string>
#include <utility>
#include <vector>

#include "texture_set/export_target.h"

namespace weftlight::texture_set {

/// What a renderer of Blender adds to the script.
struct BlenderRenderer {
  const char* name;          // as Blender shows it
  const char* other;         // the other renderer
  const char* other_target;  // the id of its target
  bool eevee;
  const char* facts;                                        // Python: the numbers of the faces
  const char* face;                                         // Python: face(side), the shader of a face
  std::vector<std::pair<std::string, std::string>> values;  // for {KEY} in both
};

/// A tuple of three numbers.
std::string python_colour(const glm::vec3& colour);
/// The logarithms of a tint, as growth() in the script takes them: of the colour, then of the reflectance.
std::string python_tint(const light::ViewTint& tint);

base::Result<void> write_blender_material(const SetFacts& set, const BlenderRenderer& renderer);

}  // namespace weftlight::texture_set
