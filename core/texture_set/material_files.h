#pragma once
// The materials that go with the images of a set: a mesh with them, the engine's own text files, a quad that proves the
// scale. Texture coordinates are millimetres everywhere; each material says itself how many repeats a millimetre has.

#include <string>

#include "draft/design.h"
#include "drape/mesh.h"
#include "texture_set/face_source.h"
#include "texture_set/names.h"
#include "texture_set/targets.h"

namespace weftlight::texture_set {

/// A set whose images are written.
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

/// True where the material comes with a mesh.
bool needs_mesh(ExportTarget target);

struct MaterialFile {
  std::string file;  // the one to open first; empty when the target needs none
  std::string error;
};
MaterialFile write_materials(const SetFacts& set);

/// A hanging square, 100 mm a side, with texture coordinates in millimetres.
Mesh scale_quad();

// The parts, one a file of code. Empty: done; else what went wrong.
std::string write_gltf_material(const SetFacts& set, const std::string& extension);
std::string write_blender_script(const SetFacts& set);
std::string write_godot_material(const SetFacts& set);
std::string write_unreal_script(const SetFacts& set);
std::string write_unity_material(const SetFacts& set);
std::string write_u3m(const SetFacts& set);
std::string write_materialx(const SetFacts& set);

/// Every {KEY} of the template becomes its value.
std::string filled(std::string text, const std::vector<std::pair<std::string, std::string>>& values);
std::string number(double v);
/// File of the target's image whose suffix this is.
std::string image_named(const SetFacts& set, const std::string& suffix, Face face);
/// Share of the body's light that leaves behind: mean over the threads; 0 where there is next to none.
float mean_transmission(const SetFacts& set);
/// 32 hexadecimal digits that stay the same for the same text.
std::string digest(const std::string& text);

}  // namespace weftlight::texture_set
