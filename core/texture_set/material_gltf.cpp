// The images of the set on the draped mesh, one material for each face.

#include "files/files.h"
#include "texture_set/material_files.h"

namespace weftlight::texture_set {
namespace {

/// The images of a Blender set belong to its script; its .glb embeds glTF images, at most 1024 texels a side.
GltfMaterial material_of(const SetFacts& set, Face face) {
  const FaceSource& source = set.of(face);
  GltfMaterial m;
  m.name = set.name + (face == Face::kBack ? "_back" : "");
  const bool whole = source.band() == source.size().height;
  const SurfaceTexels embedded = set.target == ExportTarget::kGltf ? SurfaceTexels{}
                                 : whole                           ? source.rows(0, source.size().height)
                                                                   : source.small();
  const auto set_image = [&](GltfImage& image, const char* suffix, size_t row) {
    if (set.target == ExportTarget::kGltf) image.file = image_named(set, suffix, face);
    else image.png = encode_png(pack(image_rows(ExportTarget::kGltf)[row], embedded));
  };
  set_image(m.base_color, "_basecolor", 0);
  set_image(m.orm, "_orm", 1);
  set_image(m.normal, "_normal", 2);
  set_image(m.anisotropy, "_anisotropy", 3);
  m.anisotropy_strength = 1;
  // The fit of a Blender set has no sheen, and Blender 3 would import it as an unscaled velvet.
  if (set.target == ExportTarget::kGltf && source.fit().sheen > 0) {
    set_image(m.sheen, "_sheen", 4);
    m.sheen_color = {1, 1, 1};
    m.sheen_roughness = 1;
  }
  m.uv_scale_u = 1 / source.small().width_mm;
  m.uv_scale_v = 1 / source.small().depth_mm;
  m.f0 = source.fit().f0, m.f90 = source.fit().f90;
  m.transmission = mean_transmission(set);
  m.alpha = set.alpha == Alpha::kOpaque ? GltfAlpha::kOpaque
            : set.alpha == Alpha::kMask ? GltfAlpha::kMask
                                        : GltfAlpha::kBlend;
  return m;
}

}  // namespace

std::string write_gltf_material(const SetFacts& set, const std::string& extension) {
  const GltfMaterial front = material_of(set, Face::kFront), back = material_of(set, Face::kBack);
  return problem_of(write_mesh(set.folder + "/" + set.name + extension, set.mesh, &front, &back));
}

}  // namespace weftlight::texture_set
