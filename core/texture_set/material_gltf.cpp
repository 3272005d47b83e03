// The set's own images on the draped mesh, one material a face.

#include "files/files.h"
#include "texture_set/material_files.h"

namespace weftlight::texture_set {
namespace {

/// The Blender set's images are those of its script: its .glb carries glTF's, embedded, of a large set at 1024.
GltfMaterial material_of(const SetFacts& set, Face face) {
  const FaceSource& source = set.of(face);
  GltfMaterial m;
  m.name = set.name + (face == Face::kBack ? "_back" : "");
  const bool whole = source.band() == source.size().height;
  const SurfaceTexels embedded = set.target == ExportTarget::kGltf ? SurfaceTexels{}
                                 : whole                           ? source.rows(0, source.size().height)
                                                                   : source.small();
  const auto take = [&](GltfImage& image, const char* suffix, size_t row) {
    if (set.target == ExportTarget::kGltf) image.file = image_named(set, suffix, face);
    else image.png = encode_png(pack(image_rows(ExportTarget::kGltf)[row], embedded));
  };
  take(m.base_color, "_basecolor", 0);
  take(m.orm, "_orm", 1);
  take(m.normal, "_normal", 2);
  take(m.anisotropy, "_anisotropy", 3);
  m.anisotropy_strength = 1;
  // The fit of the Blender set has none, and Blender 3's importer would add a velvet that is not scaled.
  if (set.target == ExportTarget::kGltf && source.fit().sheen > 0) {
    take(m.sheen, "_sheen", 4);
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
  return write_mesh(set.folder + "/" + set.name + extension, set.mesh, &front, &back);
}

}  // namespace weftlight::texture_set
