// Any bytes as a .glb or .gltf: parsing never crashes, and a mesh that is read can be drawn.

#include <unistd.h>

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "files/files.h"
#include "require.h"

using weftlight::drape::Mesh, weftlight::drape::Vec3;
using weftlight::files::read_mesh;

namespace {

/// A file of this process, rewritten for every input.
const std::string& scratch_path() {
  static const std::string path =
      (std::filesystem::temp_directory_path() / ("weftlight-fuzz-" + std::to_string(::getpid()) + ".glb")).string();
  static const int at_exit = std::atexit([] { std::remove(scratch_path().c_str()); });
  (void)at_exit;
  return path;
}

bool is_unit(const Vec3& v) { return std::abs(std::hypot(v[0], v[1], v[2]) - 1) < 1e-3f; }

void require_drawable(const Mesh& mesh) {
  const size_t n = mesh.position_mm.size();
  require(mesh.normal.size() == n && mesh.tangent.size() == n && mesh.uv_mm.size() == n,
          "attributes are as long as each other");
  require(!mesh.index.empty() && mesh.index.size() % 3 == 0, "there are whole triangles");
  for (const uint32_t i : mesh.index) require(i < n, "an index is a vertex");
  for (size_t i = 0; i < n; ++i) {
    for (int k = 0; k < 3; ++k) require(std::isfinite(mesh.position_mm[i][k]), "positions are finite");
    for (int k = 0; k < 2; ++k) require(std::isfinite(mesh.uv_mm[i][k]), "texture coordinates are finite");
    require(is_unit(mesh.normal[i]), "normals are of unit length");
    require(is_unit(mesh.tangent[i]), "tangents are of unit length");
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  {
    std::ofstream out(scratch_path(), std::ios::binary | std::ios::trunc);
    out.write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
  }
  const weftlight::base::Result<Mesh> read = read_mesh(scratch_path());
  require(read || !read.error().text.empty(), "a rejection has a reason");
  if (read) require_drawable(*read);
  return 0;
}
