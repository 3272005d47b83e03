#pragma once
// The only place that touches OpenImageIO and tinygltf.

#include <optional>
#include <string>
#include <vector>

#include "base/resources.h"
#include "cloth/maps.h"
#include "drape/mesh.h"
#include "files/names.h"

namespace weftlight::files {

/// Interleaved float image, row 0 at the top.
struct Image {
  int width = 0, height = 0, channels = 0;
  std::vector<float> texels;
};
enum class PixelType { kU8, kU16, kHalf, kFloat };

/// Writes .png, .exr, .tif, .jpg by extension, beside the target and renamed into place. 8- and 16-bit
/// values are taken as they are (0..1): the caller encodes sRGB. Empty string: done; else what went wrong.
/// `channels`: names for an .exr, one a channel or none; other formats have no place for them.
std::string write_image(const std::string& path, const Image& image, PixelType type,
                        const std::vector<std::string>& channels = {});
/// Writes a tiled EXR that holds a whole mip chain; each level halves the one before, down to 1 x 1 or
/// wherever `levels` ends. Values of `type` kHalf or kFloat.
std::string write_mipmapped_exr(const std::string& path, const std::vector<Image>& levels, PixelType type,
                                const std::vector<std::string>& channels = {});
struct ReadImage {
  std::optional<Image> image;
  std::string error;
};
/// `level` of a mip chain; 0 of any image.
ReadImage read_image(const std::string& path, int level = 0);

struct ReadMesh {
  std::optional<Mesh> mesh;
  std::string error;  // what is wrong and what to do
};
/// Loads the first mesh scene of a .glb or .gltf (all primitives joined, node transforms applied, metres
/// to millimetres). UVs are taken as millimetres when asset.extras.weftlight_uv_mm is set, otherwise one
/// UV unit is the size that makes texture area equal surface area.
ReadMesh read_mesh(const std::string& path);

/// A PNG for a material: bytes, or a file in the folder of the mesh that is written.
struct GltfImage {
  std::vector<unsigned char> png;
  std::string file;
  bool empty() const { return png.empty() && file.empty(); }
};
enum class GltfAlpha { kOpaque, kMask, kBlend };
/// glTF material inputs.
struct GltfMaterial {
  std::string name;
  GltfImage base_color, orm, normal, anisotropy, sheen;
  float uv_scale_u = 1, uv_scale_v = 1;  // KHR_texture_transform: repeats a millimetre
  Linear sheen_color{0, 0, 0};
  float sheen_roughness = 0.5f;
  float anisotropy_strength = 0, anisotropy_rotation = 0;
  float f0 = 0.04f, f90 = 1;  // of its dielectric, straight and grazing: KHR_materials_specular
  float transmission = 0;     // share of the body's light that leaves behind
  GltfAlpha alpha = GltfAlpha::kOpaque;
};
/// Writes a .glb (or .gltf with files beside it) of the mesh; without material when `front` is null. With `back` the
/// triangles stand twice, each side with its own material; else one is seen from both sides. KHR_materials_
/// diffuse_transmission is written to a .gltf alone: the Khronos validator does not know it yet.
std::string write_mesh(const std::string& path, const Mesh& mesh, const GltfMaterial* front,
                       const GltfMaterial* back = nullptr);

/// A shipped drape by name (presets/meshes/NAME.glb) or a file by path.
ReadMesh load_drape(const std::string& name_or_path);

/// Writes a line of text into an image, (x, y) the left end of its base line, `size` texels high. Needs a
/// font of the system (third_party/packages.txt brings one); without any the image stays as it is.
void draw_text(Image& image, int x, int y, int size, const std::string& text, const std::vector<float>& colour);

/// PNG bytes in memory, for embedding.
std::vector<unsigned char> encode_png(const Image& image, PixelType type = PixelType::kU8);

}  // namespace weftlight::files
