#pragma once
// How each shipped draft is made. presets/drafts and presets/yarns hold what these give; a test compares.

#include <string>
#include <vector>

#include "draft/design.h"
#include "wif/names.h"

namespace weftlight::wif {

struct PresetRecipe {
  std::string path;  // in presets/
  Design design;
};
std::vector<PresetRecipe> preset_recipes();
/// Those of presets/cloths, which are among them.
std::vector<PresetRecipe> cloth_recipes();

}  // namespace weftlight::wif
