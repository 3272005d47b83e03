#pragma once
// Options of `export` about the material and what wears it.

#include <string>

namespace weftlight::commands {

struct ExportOptions;

struct MaterialOptions {
  bool masks = false;                   // images for recolouring
  bool lods = false;                    // also sets for the middle distance and from afar
  std::string uv = "mm";                // unit of texture coordinates: mm, cm, m or tile
  float uv_right_mm = 0, uv_up_mm = 0;  // by which the cloth is moved on the mesh
};

int export_command(const ExportOptions& options, const MaterialOptions& material);

}  // namespace weftlight::commands
