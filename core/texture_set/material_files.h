#pragma once
// The materials of a set: a mesh with the images, the text files of the engine, and a quad for checking the scale.
// Texture coordinates are in millimetres everywhere; each material scales them to repeats.

#include <string>

#include "design/design.h"
#include "drape/mesh.h"
#include "texture_set/face_source.h"
#include "texture_set/names.h"
#include "texture_set/targets.h"

namespace weftlight::texture_set {

/// A set whose images are already written.
struct SetFacts {
  std::string folder, name;
  ExportTarget target = ExportTarget::kGltf;
  Alpha alpha = Alpha::kOpaque;  // not kAuto
  std::string modified;          // of the draft, ISO 8601
  const Design& design;
  const FaceSource& front;
  const FaceSource& back;
  const Mesh& mesh;
  const FaceSource& of(Face face) const { return face == Face::kFront ? front : back; }
};

/// True if the material includes a mesh.
bool needs_mesh(ExportTarget target);

struct MaterialFile {
  std::string file;  // the file to open first; empty if the target has no material
  std::string error;
};
MaterialFile write_materials(const SetFacts& set);

/// An upright square with sides of 100 mm and texture coordinates in millimetres.
Mesh scale_quad();

// One function for each target, in a file of its own. Each returns an error, or an empty string.
std::string write_gltf_material(const SetFacts& set, const std::string& extension);
std::string write_blender_script(const SetFacts& set);
std::string write_godot_material(const SetFacts& set);
std::string write_unreal_script(const SetFacts& set);
std::string write_unity_material(const SetFacts& set);
std::string write_u3m(const SetFacts& set);
std::string write_materialx(const SetFacts& set);

/// Replaces every {KEY} of the template by its value.
std::string fill_template(std::string text, const std::vector<std::pair<std::string, std::string>>& values);
std::string number(double v);
/// The file name of the target's image with this suffix.
std::string image_named(const SetFacts& set, const std::string& suffix, Face face);
/// Diffuse transmission as a fraction of the diffuse light, mean over the threads; 0 if negligible.
float mean_transmission(const SetFacts& set);
/// A hash of the text, 32 hexadecimal digits.
std::string digest(const std::string& text);

}  // namespace weftlight::texture_set
