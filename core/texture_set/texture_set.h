#pragma once
// A texture set: one full repeat of structure and colour as named, packed images for an engine, with its
// materials, a README of three lines, a contact sheet and a machine-readable texture_set.json.

#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "draft/design.h"
#include "drape/mesh.h"
#include "files/mip_file.h"
#include "texture_set/face_source.h"
#include "texture_set/names.h"
#include "texture_set/targets.h"

namespace weftlight::texture_set {

struct TextureSetOptions {
  ExportTarget target = ExportTarget::kGltf;
  std::string name;        // of the files; file_name_of() makes one from anything
  std::string source;      // the draft's file name, for the record
  std::string draft_path;  // the draft's file; empty: never saved
  std::string program_version;
  int size = 1024;     // texels of the longer side, a power of two 16..8192
  bool force = false;  // writes among files of others, over those of the same names
  Alpha alpha = Alpha::kAuto;
  float distance_m = 1;                           // whose pixels the roughness is made for; 0: none
  std::optional<MipContainer> mips{};             // beside the images, the same with mips of our own
  float tile_mm = 0;                              // least width and depth of the tile, of whole repeats; 0: one repeat
  std::string modified = "2000-01-01T00:00:00Z";  // of the draft, ISO 8601: for formats that ask
  std::string key;                                // of all that the set is made of, for is_complete()
  bool archived = false;                          // for the record: a .zip of the same name stands beside the folder
};
/// The choices that the set's bytes depend on, as text.
std::string key_of(const TextureSetOptions& options);

/// Letters, digits, '-' and '_' of a text; "cloth" when none is left.
std::string file_name_of(const std::string& text);

/// Repeats side by side and one above the other, as one period; yarns' irregularities differ among them.
Cloth tiled(const Cloth& cloth, int across, int up);

/// Texels a side that give so many to a millimetre of the design's tile: a power of two 16..8192.
int size_for(const Design& design, float texels_per_mm, float tile_mm);

/// What is amiss with the choices for this design; none: nothing.
std::vector<std::string> warnings_of(const Design& design, const TextureSetOptions& options);

/// How far a set is, and whether anybody still wants it.
struct Progress {
  std::function<void(float share)> tell{};  // 0..1, from the thread that asked for the set; empty: nobody listens
  std::stop_token stop{};
};
/// What a set that was stopped has for a problem; what was there before stands.
inline constexpr const char* kStopped = "stopped";

/// Targets without a .glb take no mesh: it may then be empty.
///
/// Writes the set into `folder`: all of it or, on failure, what was there before. Only files that an earlier set of the
/// same draft and target lists are replaced or taken away (texture_set/set_folder.h). Empty string: done; else what
/// went wrong.
std::string write_texture_set(const std::string& folder, const Design& design, const Mesh& mesh,
                              const TextureSetOptions& options, const Progress& progress = {});

/// What a set will be, both faces together, known before anything is made.
struct SetFigures {
  float width_mm = 0, depth_mm = 0;  // of the tile
  size_t ends = 0, picks = 0;        // in it
  TextureSize size;
  int images = 0;
  int64_t texel_bytes = 0;  // of all images with their mips, as a graphics card holds them uncompressed
};
/// Zeros for a draft without cloth.
SetFigures figures_of(const Design& design, const TextureSetOptions& options);
/// One face as the set's images are made of it, at most `side` texels a side. The draft has cloth.
FaceSource face_at(const Design& design, Face face, const TextureSetOptions& options, int side);

/// Empty where write_texture_set() may write without `force`, else what is there and what to do.
std::string who_is_there(const std::string& folder, const TextureSetOptions& options);

}  // namespace weftlight::texture_set
