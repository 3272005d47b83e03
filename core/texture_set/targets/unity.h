#pragma once
// What the targets of Unity share: import settings of the images, a .mat for each face and a quad. Based on: the YAML
// that Unity 2021 and later writes; its pipelines differ in the names of a material's textures, numbers and keywords.

#include <span>
#include <string>
#include <vector>

#include "texture_set/material_files.h"

namespace weftlight::texture_set {

using draft::Face;

/// The texture of a material that takes the image with this suffix.
struct UnitySlot {
  const char* suffix;
  const char* slot;
};

/// The shader Lit of a render pipeline. Lines are "name: value".
struct UnityShader {
  const char* guid;
  std::span<const UnitySlot> slots;
  std::vector<std::string> (*keywords)(const SetFacts&, Face);  // besides those of the alpha mode
  std::vector<std::string> (*floats)(const SetFacts&, Face);
  std::vector<std::string> (*colors)(const SetFacts&, Face);  // besides white as base colour
};

/// True for the alpha modes that Unity draws as alpha clipping.
bool cuts_out(Alpha alpha);

base::Result<void> write_unity_material(const SetFacts& set, const UnityShader& shader);

}  // namespace weftlight::texture_set
