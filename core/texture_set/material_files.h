#pragma once
// What the files of the targets write their materials from: the facts of a set, and the parts that several share.
// Texture coordinates are in millimetres, unless the set is made for another unit; each material scales them to
// repeats.

#include <array>
#include <map>
#include <string>
#include <vector>

#include "design/design.h"
#include "drape/mesh.h"
#include "files/mesh_uv.h"
#include "texture_set/export_target.h"
#include "texture_set/face_source.h"
#include "texture_set/mip_images.h"

namespace weftlight::texture_set {

using design::Design;
using draft::Face;
using drape::Mesh;

/// The stored values of constant images, by the file name that the image has or would have.
using Constants = std::map<std::string, std::vector<float>>;

/// A set whose images are already written.
struct SetFacts {
  std::string folder, name;
  const ExportTarget& target;
  Alpha alpha = Alpha::kOpaque;  // not kAuto
  std::string modified;          // of the draft, ISO 8601
  const Design& design;
  const FaceSource& front;
  const FaceSource& back;
  const Mesh& mesh;
  const Constants& constants;
  const std::array<EmbeddedImages, 2>& embedded;  // front, back
  MipChoice mips{};
  UvMapping uv{};
  bool masks = false;  // there are images for recolouring
  const FaceSource& of(Face face) const { return face == Face::kFront ? front : back; }
};

/// From texture coordinates to repeats of the tile: coordinate x scale + offset, right and up in the image.
struct UvTransform {
  double scale_u = 1, scale_v = 1, offset_u = 0, offset_v = 0;
};
UvTransform uv_transform(const SetFacts& set);
UvTransform uv_transform(const UvMapping& uv, float width_mm, float depth_mm);
/// Texture coordinates of the set for each millimetre, right and up.
std::array<double, 2> uv_per_mm(const SetFacts& set);
/// The mesh with its coordinates in the set's unit (in Mesh::uv_mm), and what its file says of them.
Mesh mapped(const SetFacts& set, Mesh mesh);
files::MeshUv mesh_uv(const SetFacts& set);

/// An upright square with sides of 100 mm and texture coordinates in millimetres.
Mesh scale_quad();

/// Writes it beside the images as NAME_quad.glb.
base::Result<void> write_scale_quad(const SetFacts& set);

/// Replaces every {KEY} of the template by its value.
std::string fill_template(std::string text, const std::vector<std::pair<std::string, std::string>>& values);
std::string number(double v);
/// The part between the name and the suffix of a file of that face.
std::string face_suffix(const ExportTarget& target, Face face);
/// The file name of the image of a row.
std::string image_file(const ExportTarget& target, const ImageRow& row, const std::string& name, Face face);
/// The file name of the target's image with this suffix.
std::string image_named(const SetFacts& set, const std::string& suffix, Face face);
/// True if the materials name a .dds of this row, with mipmaps, instead of its image.
bool has_dds(const SetFacts& set, const ImageRow& row, Face face);
std::string dds_file(const ExportTarget& target, const ImageRow& row, const std::string& name, Face face);
/// The file that a material names for the image with this suffix.
std::string mipped_image_named(const SetFacts& set, const std::string& suffix, Face face);
/// The values of an image that is a factor; empty: it is an image.
std::vector<float> factors_of(const SetFacts& set, const std::string& suffix, Face face);
/// The name of the material of a face.
std::string material_name(const SetFacts& set, Face face);
/// Diffuse transmission as a fraction of the diffuse light, mean over the threads; 0 if negligible.
float mean_transmission(const SetFacts& set);
/// A hash of the text, 32 hexadecimal digits.
std::string digest(const std::string& text);

}  // namespace weftlight::texture_set
