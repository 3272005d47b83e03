#pragma once
// What the exporter knows of an engine or a format. Each is a file in targets/; the table of them all is targets.h.

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/result.h"
#include "files/mip_file.h"
#include "light/engine_fit.h"
#include "texture_set/channels.h"

namespace weftlight::texture_set {

using files::MipFormat;
using light::EngineModel;

struct SetFacts;
class FaceSource;

/// PNG files within another file.
using EmbeddedImages = std::vector<std::vector<unsigned char>>;

/// Alpha mode of the gaps between threads.
enum class Alpha { kAuto, kOpaque, kMask, kHashed, kBlend };

/// One unit of a mesh's texture coordinates.
enum class UvUnit { kMm, kCm, kM, kTile };

/// How the texture coordinates of a mesh are meant.
struct UvMapping {
  UvUnit unit = UvUnit::kMm;
  // By which the cloth is moved on the mesh, in mm: right and up as in the images.
  float right_mm = 0, up_mm = 0;
};
std::optional<UvUnit> uv_unit_named(const std::string& name);
const char* uv_unit_name(UvUnit unit);   // as --uv names it
const char* uv_unit_title(UvUnit unit);  // English plural; show tr()

struct ExportTarget {
  const char* id;                    // as --target, folders and texture_set.json name it
  const char* title;                 // the product name, as in "Unreal Engine"; show tr(title)
  std::span<const ImageRow> images;  // in the order of the contact sheet
  const char* normal = "+Y";         // sign of the green channel of the normal map: "+Y" or "-Y"
  const char* front = "";            // between name and suffix of a file of the front; of the back it is "_back"

  // The material model to which a set is fitted. `highlight` and `sheen` describe it in docs/engines.md.
  EngineModel model{};
  std::optional<EngineModel> metal_model{};  // for cloth with metal yarns, if it differs
  std::optional<EngineModel> older_model{};  // of older versions, if they need other numbers
  const char* highlight = "";
  const char* sheen = "";
  bool path_traced = false;  // averages the radiance of texels: each texel keeps its own microfacets
  bool raw = false;          // the cloth itself instead of a fitted material: with horizons, and mips of its own

  Alpha open = Alpha::kBlend;  // best mode for cloth with gaps
  // The container of colours with mipmaps, if the engine would average encoded colours and its material names ours.
  std::optional<MipFormat> color_mips{};
  bool names_dds = false;    // the materials name .dds images, which have mipmaps, where the set has them
  bool keeps_masks = false;  // mipmaps keep the coverage of a mask, or there are none

  const char* material = "";  // file to open first: name + this; "": the set has none
  base::Result<void> (*write_material)(const SetFacts&) = nullptr;  // all files but the images
  bool wears_mesh = false;                                          // the material comes on the chosen mesh
  bool embeds_images = false;                                       // and its file contains the images a second time
  bool sized_material = false;  // its material gives the size of the tile, and takes no texture coordinates

  // Images that its material contains, made while the texels of a face are in memory.
  EmbeddedImages (*embedded)(const FaceSource&) = nullptr;

  // Line for the README of a set: what to do first, with {name} for the name of the set; show fill(tr(note), ...).
  const char* note = "";
};

/// The model of the target's material. metal: there are metal yarns.
const EngineModel& engine_model(const ExportTarget& target, bool metal);

/// Resolves kAuto: opaque if gaps are only pinholes, else the best mode of the target. `coverage`: mean, 0..1. A target
/// without hashed alpha gets blending.
Alpha alpha_for(const ExportTarget& target, Alpha requested, float coverage);
std::optional<Alpha> alpha_named(const std::string& name);
const char* alpha_name(Alpha alpha);

}  // namespace weftlight::texture_set
