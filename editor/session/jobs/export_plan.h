#pragma once
// The options of a texture export (target programs, resolution, folder), and figures of its result before anything is
// written.

#include <optional>
#include <string>
#include <vector>

#include "texture_set/texture_set.h"

namespace weftlight::session {

using design::Design;
using files::MipFormat;
using texture_set::Alpha, texture_set::ExportTarget, texture_set::SetFigures, texture_set::TextureSetOptions;

struct ExportPlan {
  std::vector<const ExportTarget*> targets{&texture_set::targets::kGltf};  // each at most once
  bool by_density = false;
  int size = 1024;           // texels of the longer side, a power of two 16..8192
  float texels_per_mm = 40;  // with by_density: the least density
  float tile_cm = -1;        // least width and height of the tile; 0: one repeat; negative: as its yarns need
  Alpha alpha = Alpha::kAuto;
  std::optional<MipFormat> mips;  // files with mipmaps beside the images; raw sets have their own
  bool lods = false;              // also sets for larger distances; raw sets have none
  std::string folder;             // each set is a folder inside it
  bool watch = false;             // exports again after each edit
};

/// One texture set in its own folder.
struct ExportJob {
  std::string folder;
  TextureSetOptions options;
};
/// In the order of the targets; levels of detail after the set that they belong to. `draft_path` is empty if the draft
/// was never saved.
std::vector<ExportJob> jobs_of(const ExportPlan& plan, const Design& design, const std::string& draft_path,
                               const std::string& version);

struct ExportFigures {
  SetFigures set;                // of the first target; size and repeat hold for all
  float texels_a_thread = 0;     // the smaller of warp and weft
  int images = 0;                // in all sets, without their further levels of detail
  int64_t texel_bytes = 0;       // of all sets, in GPU memory
  std::vector<std::string> why;  // warnings
};
ExportFigures figures_of(const Design& design, const std::vector<ExportJob>& jobs);

/// Foreign files in the folders of the jobs, one line per folder. Files of the same sets do not count.
std::vector<std::string> in_the_way(const std::vector<ExportJob>& jobs);
/// Number of files of the same sets that will be replaced.
int replaced_files(const std::vector<ExportJob>& jobs);

/// Adds or removes the target; the last one stays.
void toggle(ExportPlan& plan, const ExportTarget* target);

/// "14 MB", for display.
std::string shown_bytes(int64_t bytes);

}  // namespace weftlight::session
