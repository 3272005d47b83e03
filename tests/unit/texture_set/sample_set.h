#pragma once
// A small design to export, its options, and the list of its set.

#include <fstream>
#include <string>

#include "base/json.h"
#include "texture_set/texture_set.h"
#include "weaves/weaves.h"

namespace weftlight::texture_set {

using design::Design, design::Yarn;
using weaves::herringbone;

/// A two-coloured herringbone with a yarn of each kind; its repeat has 16 ends x 4 picks and is not square.
inline Design sample_design() {
  Design design = herringbone({2, 2}, 8, {32, 16});
  design.title = "Sample";
  Yarn metal;
  metal.lobes.metallic = true;
  metal.lobes.across_width = 0.1f;
  design.yarns = {Yarn{}, metal};
  for (int e = 0; e < design.draft.ends(); e += 8) design.draft.warp.yarn[static_cast<size_t>(e)] = 1;
  return design;
}

inline TextureSetOptions options_for(const ExportTarget& target, int size = 128) {
  TextureSetOptions options;
  options.target = &target, options.name = "sample", options.size = size;
  options.source = "sample.wif", options.draft_path = "drafts/sample.wif", options.program_version = "1.2.3";
  return options;
}

inline nlohmann::json list_of(const std::string& folder) {
  return nlohmann::json::parse(std::ifstream(folder + "/texture_set.json"));
}

}  // namespace weftlight::texture_set
