#pragma once
// The mesh with glTF materials, for targets that come with a .glb.

#include <string>

#include "texture_set/material_files.h"

namespace weftlight::texture_set {

/// Where the images of a glTF material are: the files of the set, or copies inside the .glb, at most 1024 texels a
/// side and without sheen, for a set whose own images are for something else.
enum class GltfImages { kBeside, kEmbedded };

/// The images of kEmbedded, for ExportTarget::embedded.
EmbeddedImages embedded_images(const FaceSource& source);

/// extension: ".glb" or ".gltf".
base::Result<void> write_gltf(const SetFacts& set, const std::string& extension, GltfImages images);

}  // namespace weftlight::texture_set
