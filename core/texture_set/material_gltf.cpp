// The set's own images on the draped mesh, one material a face.

#include "files/files.h"
#include "texture_set/material_files.h"

namespace weftlight::texture_set {
namespace {

constexpr float kLeastTransmission = 0.005f;

/// Share of the body's light that leaves behind: mean over the threads.
float mean_transmission(const Cloth& cloth) {
  float sum = 0;
  for (const auto* threads : {&cloth.ends, &cloth.picks}) {
    for (const ThreadBody& t : *threads) {
      const Lobes& lobes = cloth.yarns[static_cast<size_t>(t.yarn)].lobes;
      sum += lobes.metallic ? 0 : lobes.transmission;
    }
  }
  const float mean = sum / static_cast<float>(std::max<size_t>(cloth.ends.size() + cloth.picks.size(), 1));
  return mean < kLeastTransmission ? 0 : std::min(mean, 1.0f);
}

/// The Blender set's images are those of its script: its .glb carries glTF's, embedded, of a large set at 1024.
GltfMaterial material_of(const SetFacts& set, Face face) {
  const FaceSource& source = set.of(face);
  GltfMaterial m;
  m.name = set.name + (face == Face::kBack ? "_back" : "");
  const bool whole = source.band() == source.size().height;
  const Surface embedded = set.target == Target::kGltf ? Surface{}
                           : whole                     ? source.rows(0, source.size().height)
                                                       : source.small();
  const auto take = [&](GltfImage& image, const char* suffix, size_t row) {
    if (set.target == Target::kGltf) image.file = image_named(set, suffix, face);
    else image.png = encode_png(pack(image_rows(Target::kGltf)[row], embedded));
  };
  take(m.base_color, "_basecolor", 0);
  take(m.orm, "_orm", 1);
  take(m.normal, "_normal", 2);
  take(m.anisotropy, "_anisotropy", 3);
  m.anisotropy_strength = 1;
  // The fit of the Blender set has none, and Blender 3's importer would add a velvet that is not scaled.
  if (set.target == Target::kGltf && source.fit().sheen > 0) {
    take(m.sheen, "_sheen", 4);
    m.sheen_color = {1, 1, 1};
    m.sheen_roughness = 1;
  }
  m.uv_scale_u = 1 / source.small().width_mm;
  m.uv_scale_v = 1 / source.small().depth_mm;
  m.f0 = source.fit().f0, m.f90 = source.fit().f90;
  m.transmission = mean_transmission(source.cloth());
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
