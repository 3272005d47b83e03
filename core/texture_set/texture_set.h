#pragma once
// A texture set: one full repeat of structure and colour as named, packed images for an engine, with materials, a short
// README, a contact sheet and a machine-readable texture_set.json.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "design/design.h"
#include "drape/mesh.h"
#include "files/mip_file.h"
#include "texture_set/export_progress.h"
#include "texture_set/face_source.h"
#include "texture_set/targets.h"
#include "texture_set/tile.h"

namespace weftlight::texture_set {

using cloth::Cloth;
using design::Design;
using draft::Face;
using drape::Mesh;
using files::MipFormat;

struct TextureSetOptions {
  const ExportTarget* target = &targets::kGltf;  // never null
  std::string name;                              // of the files; see file_name_of()
  std::string source;                            // file name of the draft, for texture_set.json
  std::string draft_path;                        // path of the draft; empty: never saved
  std::string program_version;
  int size = 1024;     // texels of the longer side, a power of two 16..8192
  int tile_size = 0;   // the same of the set that this one is a level of detail of, whose tile it has; 0: none
  bool force = false;  // writes into a folder with other files, and replaces those of the same names
  Alpha alpha = Alpha::kAuto;
  float distance_m = 1;                      // viewing distance of the footprint in the roughness; 0: no footprint
  std::optional<MipFormat> mips{};           // images with prefiltered mipmaps beside the others
  UvMapping uv{};                            // of the meshes that wear the material
  ThreadDetail detail = ThreadDetail::kAll;  // of the level of detail; size and distance are given for it
  bool masks = false;                        // images for recolouring (texture_set/recolour.h)
  float texels_per_mm = 0;                   // that set_density() was asked for; 0: size was chosen
  float tile_mm = 0;  // least width and depth of a tile of whole repeats; 0: one repeat; or kTileOfYarns
  std::string modified = "2000-01-01T00:00:00Z";  // time of the draft, ISO 8601, for formats that need it
  std::string key;                                // hash of all inputs of the set, for is_complete()
  bool archived = false;                          // for texture_set.json: a .zip of the same name is beside the folder
};
/// The options of a level of detail, 0 to kLods - 1: each a quarter as large as the one before, seen from twice as far,
/// and with less of the threads. The name gets "-lod1", "-lod2".
TextureSetOptions at_lod(TextureSetOptions options, int lod);

/// The options that change the bytes of the set, as text.
std::string key_of(const TextureSetOptions& options);

/// A name in ASCII letters, digits, '-' and '_', at most 97 bytes, that every engine and file system takes: "Koper" of
/// "K\u00F6per". A text with letters of other scripts ends in six hexadecimal digits of its own, in place of them;
/// where nothing else is left, and before the name of a device of Windows, "cloth" comes first.
std::string file_name_of(const std::string& text);

/// Sets the size, a power of two of 16..8192, for at least so many texels per millimetre along both sides of the
/// design's tile, or 8192 where that is not enough; with kTileOfYarns the tile, too.
void set_density(TextureSetOptions& options, const Design& design, float texels_per_mm);

/// Warnings about the options for this design.
std::vector<std::string> warnings_of(const Design& design, const TextureSetOptions& options);

/// The fits of a set's faces that its levels of detail stay beside; without target: not made yet.
struct FinestFits {
  const ExportTarget* target = nullptr;
  EngineFit front{}, back{};
};
/// What sets leave for those that are written next: of one design, with options that differ in target and level of
/// detail alone. These have the same files to the byte without it, in more time.
struct SharedWork {
  FinestFits finest{};
  std::array<std::array<MeasuredLight, 2>, kLods> light{};  // by level of detail; front, back
};

/// Writes the set into `folder`, completely or not at all. Only files that an earlier set of the same draft and target
/// lists are replaced or removed (texture_set/set_folder.h). The mesh may be empty for targets without a .glb.
base::Result<void> write_texture_set(const std::string& folder, const Design& design, const Mesh& mesh,
                                     const TextureSetOptions& options, const ExportProgress& progress = {},
                                     SharedWork* shared = nullptr);

/// The size of a set with both faces, known before it is made.
struct SetFigures {
  float width_mm = 0, depth_mm = 0;  // of the tile
  size_t ends = 0, picks = 0;        // in it
  TextureSize size;
  int images = 0;
  int64_t texel_bytes =
      0;  // of all images with mipmaps in the memory of a graphics card; compressed are those in blocks alone
};
/// Zeros for a draft without cloth.
SetFigures figures_of(const Design& design, const TextureSetOptions& options);
/// One face as it is exported, with at most `side` texels per side. The draft must have cloth.
FaceSource face_at(const Design& design, Face face, const TextureSetOptions& options, int side);

/// Whether write_texture_set() can write without `force`, or what is in the way.
base::Result<void> check_set_folder(const std::string& folder, const TextureSetOptions& options);

}  // namespace weftlight::texture_set
