// glTF 2.0: the images on the draped mesh, one material for each face. Based on: its specification with
// KHR_materials_anisotropy, KHR_materials_sheen and KHR_materials_specular.

#include "texture_set/targets/gltf.h"

#include <cmath>

#include "base/mark.h"
#include "design/srgb.h"
#include "files/files.h"
#include "files/mesh_uv.h"
#include "texture_set/targets.h"

namespace weftlight::texture_set {

using design::srgb_decoded;
using draft::Face;
using files::GltfAlpha, files::GltfImage, files::GltfMaterial, files::MeshUv, files::encode_png, files::write_mesh;

namespace {

using enum Channel;
using enum PixelType;

constexpr ImageRow kImages[] = {
    {"", "_basecolor", ".png", kU8, true, kBaseCoverage},
    {"", "_orm", ".png", kU8, false, {kOcclusion, kRoughnessNarrow, kMetal, kNone}},
    {"", "_normal", ".png", kU8, false, kNormalUp},
    {"", "_anisotropy", ".png", kU8, false, {kWideX, kWideY, kGltfAnisotropy, kNone}, true},
    {"", "_sheen", ".png", kU8, true, {kSheenR, kSheenG, kSheenB, kSheenRoughness}, true},
};

void set_sheen(GltfMaterial& m, const SetFacts& set, Face face) {
  if (const std::vector<float> even = factors_of(set, kImages[4].suffix, face); !even.empty()) {
    m.sheen_color = {srgb_decoded(even[0]), srgb_decoded(even[1]), srgb_decoded(even[2])};
    m.sheen_roughness = even[3];
    return;
  }
  m.sheen.file = image_named(set, kImages[4].suffix, face);
  m.sheen_color = {1, 1, 1};
  m.sheen_roughness = 1;
}

GltfMaterial material_of(const SetFacts& set, Face face, GltfImages images) {
  const FaceSource& source = set.of(face);
  GltfMaterial m;
  m.name = material_name(set, face);
  const bool beside = images == GltfImages::kBeside;
  const auto set_image = [&](GltfImage& image, size_t row) {
    if (beside) image.file = image_named(set, kImages[row].suffix, face);
    else image.png = set.embedded[face == Face::kFront ? 0 : 1][row];
  };
  set_image(m.base_color, 0);
  set_image(m.orm, 1);
  set_image(m.normal, 2);
  if (const std::vector<float> even = factors_of(set, kImages[3].suffix, face); beside && !even.empty()) {
    m.anisotropy_strength = even[2];
    m.anisotropy_rotation = std::atan2(2 * even[1] - 1, 2 * even[0] - 1);
  } else {
    set_image(m.anisotropy, 3);
    m.anisotropy_strength = 1;
  }
  // No other target that writes a .glb fits this sheen, and Blender 3 would import it as an unscaled velvet.
  if (beside && source.fit().has_sheen()) {
    set_sheen(m, set, face);
  }
  const UvTransform uv = uv_transform(set);
  m.uv_scale_u = static_cast<float>(uv.scale_u), m.uv_scale_v = static_cast<float>(uv.scale_v);
  const glm::vec3& f0 = source.fit().f0;
  m.f0 = {f0.r, f0.g, f0.b}, m.f90 = source.fit().f90;
  m.transmission = mean_transmission(set);
  m.alpha = set.alpha == Alpha::kOpaque ? GltfAlpha::kOpaque
            : set.alpha == Alpha::kMask ? GltfAlpha::kMask
                                        : GltfAlpha::kBlend;
  return m;
}

base::Result<void> write_material(const SetFacts& set) {
  return write_gltf(set, ".glb", GltfImages::kBeside).and_then([&set] {
    return write_gltf(set, ".gltf", GltfImages::kBeside);
  });
}

}  // namespace

EmbeddedImages embedded_images(const FaceSource& source) {
  const bool whole = source.band() == source.size().height;
  const SurfaceTexels all = whole ? source.rows(0, source.size().height) : SurfaceTexels{};
  EmbeddedImages out;
  for (const ImageRow& row : std::span(kImages).first(4))  // without sheen
    out.push_back(encode_png(pack(row, whole ? all : source.small())));
  return out;
}

base::Result<void> write_gltf(const SetFacts& set, const std::string& extension, GltfImages images) {
  const GltfMaterial front = material_of(set, Face::kFront, images), back = material_of(set, Face::kBack, images);
  const std::string path = set.folder + "/" + set.name + extension;
  const MeshUv uv = mesh_uv(set);
  return uv.millimetres ? write_mesh(path, set.mesh, &front, &back, uv)
                        : write_mesh(path, mapped(set, set.mesh), &front, &back, uv);
}

const ExportTarget targets::kGltf{
    .id = "gltf",
    .title = "glTF",
    .images = kImages,
    .model = light::kGltfModel,
    .highlight = "anisotropic GGX; both reflectances by `KHR_materials_specular` and `KHR_materials_ior`",
    .sheen = "Charlie, `KHR_materials_sheen`",
    .material = ".glb",
    .write_material = write_material,
    .wears_mesh = true,
    .embeds_images = true,
    .note = base::mark("Load {name}.glb, one file with its images, or {name}.gltf, which reads {name}.bin and the "
                       "images of this folder; "
                       "its materials are for your own meshes too."),
};

}  // namespace weftlight::texture_set
