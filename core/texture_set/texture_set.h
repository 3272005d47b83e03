#pragma once
// A texture set: one full repeat of structure and colour as named, packed images for an engine, with its
// material, a README of three lines, a contact sheet and a machine-readable texture_set.json.

#include <string>

#include "draft/design.h"
#include "drape/mesh.h"
#include "texture_set/names.h"
#include "texture_set/targets.h"

namespace weftlight::texture_set {

struct TextureSetOptions {
  Target target = Target::kGltf;
  std::string name;        // of the files; file_name_of() makes one from anything
  std::string source;      // the draft's file name, for the record
  std::string draft_path;  // the draft's file; empty: never saved
  std::string program_version;
  int size = 1024;     // texels of the longer side, a power of two 16..8192
  bool force = false;  // writes among files of others, over those of the same names
};

/// Letters, digits, '-' and '_' of a text; "cloth" when none is left.
std::string file_name_of(const std::string& text);

/// Texels of the images: the longer side has `size`, the other the nearest power of two that keeps texels
/// about square, at least 16.
struct TextureSize {
  int width = 0, height = 0;
};
TextureSize texture_size(float width_mm, float depth_mm, int size);

/// Targets without a .glb take no mesh: it may then be empty.
///
/// Writes the set into `folder`: all of it or, on failure, what was there before. Only files that an earlier set of the
/// same draft and target lists are replaced or taken away (texture_set/set_folder.h). Empty string: done; else what
/// went wrong.
std::string write_texture_set(const std::string& folder, const Design& design, const Mesh& mesh,
                              const TextureSetOptions& options);

/// Empty where write_texture_set() may write without `force`, else what is there and what to do.
std::string who_is_there(const std::string& folder, const TextureSetOptions& options);

}  // namespace weftlight::texture_set
