#pragma once
// Images and meshes in files. The only folder that uses OpenImageIO and tinygltf.

#include <string>
#include <vector>

#include "base/resources.h"
#include "base/result.h"
#include "cloth/curves.h"
#include "cloth/maps.h"
#include "drape/mesh.h"

namespace weftlight::files {

using cloth::Linear;
using drape::Mesh;

/// Interleaved float image, row 0 at the top.
struct Image {
  int width = 0, height = 0, channels = 0;
  std::vector<float> texels;
};
enum class PixelType { kU8, kU16, kHalf, kFloat };

/// Loads the image library ahead of the first picture that is read, or written as something else than PNG, which would
/// wait half a second for it (files/at_runtime). Reports nothing: if the library is missing, that picture's own call
/// says so.
void load_pictures();

/// Writes .png, .exr, .tif or .jpg by extension, atomically. 8- and 16-bit values are stored as given (0..1): the
/// caller encodes sRGB. `channels`: names for an .exr, one per channel or none; other formats do not store them.
base::Result<void> write_image(const std::string& path, const Image& image, PixelType type,
                               const std::vector<std::string>& channels = {});
struct ImageSize {
  int width = 0, height = 0;  // pixels
};
/// Of the file's header; no pixel is read.
base::Result<ImageSize> read_image_size(const std::string& path);
/// `level`: of a mip chain; 0 for other images. An image that is too large, or larger than a file of this length can
/// hold, is an error before memory is taken for it.
base::Result<Image> read_image(const std::string& path, int level = 0);

/// Reads the default scene of a .glb or .gltf: primitives are joined, node transforms applied, metres become
/// millimetres. UVs are millimetres if asset.extras.weftlight_uv_mm is set, otherwise they are scaled so that texture
/// area equals surface area.
base::Result<Mesh> read_mesh(const std::string& path);

/// A PNG of a material: bytes, or a file in the folder of the mesh.
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
  float uv_scale_u = 1, uv_scale_v = 1;  // KHR_texture_transform: repeats per millimetre
  Linear sheen_color{0, 0, 0};
  float sheen_roughness = 0.5f;
  float anisotropy_strength = 0, anisotropy_rotation = 0;
  Linear f0{0.04f, 0.04f, 0.04f};  // reflectance at normal incidence: KHR_materials_specular, _ior
  float f90 = 1;                   // and at grazing incidence
  float transmission = 0;          // diffuse transmission as a fraction of the diffuse light
  GltfAlpha alpha = GltfAlpha::kOpaque;
};
/// Writes the mesh as .glb, or as .gltf with files beside it. Without material if `front` is null. With `back` the
/// triangles are written twice, each side with its own material; otherwise the material is double sided.
base::Result<void> write_mesh(const std::string& path, const Mesh& mesh, const GltfMaterial* front,
                              const GltfMaterial* back = nullptr);

/// Writes USD text (.usda): BasisCurves for each group, with width and colour, a material, and as primvars the thread
/// and the twist. The stage is in millimetres, the face of the cloth towards +z.
base::Result<void> write_curves(const std::string& path, const cloth::Curves& curves);

/// An error with the names of the shipped drapes if this is none of them, nor can it be the path of a mesh.
base::Result<void> check_drape(const std::string& name_or_path);
/// Reads a shipped drape by name (presets/meshes/NAME.glb), or a file by path.
base::Result<Mesh> load_drape(const std::string& name_or_path);

/// Draws a line of text into an image; (x, y) is the left end of the base line, `size` the height in texels. Needs a
/// font of the system (third_party/packages.txt installs one); without a font nothing is drawn.
void draw_text(Image& image, int x, int y, int size, const std::string& text, const std::vector<float>& colour);

/// PNG bytes in memory, for embedding.
std::vector<unsigned char> encode_png(const Image& image, PixelType type = PixelType::kU8);

}  // namespace weftlight::files
