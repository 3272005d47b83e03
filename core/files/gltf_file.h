#pragma once
// A file of glTF 2.0, not trusted: its JSON is parsed with limits on depth and number and reduced to what a mesh needs
// (no images, materials, animations or extras) before tinygltf sees it, and it names no file outside its own folder.

#include <tiny_gltf.h>

#include <stdexcept>
#include <string>

namespace weftlight::files {

/// What is wrong and what to do; caught in read_mesh().
struct UnreadableMesh : std::runtime_error {
  using std::runtime_error::runtime_error;
};

[[noreturn]] void refuse(const std::string& why);

struct GltfFile {
  tinygltf::Model model;
  bool uv_mm = false;  // its texture coordinates are millimetres: Weftlight wrote it
};

/// A .glb or .gltf with its buffers. Throws UnreadableMesh.
GltfFile read_gltf(const std::string& path);

}  // namespace weftlight::files
