#pragma once
// What a weaver chose to export: for which programs, how fine, where to; and what comes of it, known before anything is
// written.

#include <optional>
#include <string>
#include <vector>

#include "session/names.h"
#include "texture_set/texture_set.h"

namespace weftlight::session {

struct ExportPlan {
  std::vector<ExportTarget> targets{ExportTarget::kGltf};  // none twice
  bool by_density = false;
  int size = 1024;           // texels of the longer side, a power of two 16..8192
  float texels_per_mm = 40;  // where it goes by density: at least so many
  float tile_cm = 0;         // least width and depth of the tile; 0: one repeat
  Alpha alpha = Alpha::kAuto;
  std::optional<MipContainer> mips;  // beside the images; raw sets keep their own
  std::string folder;                // the sets stand in folders of their own within
  bool watch = false;                // again after each edit
};

/// One set: a folder of its own.
struct ExportJob {
  std::string folder;
  TextureSetOptions options;
};
/// In the order of the targets. `draft_path`: empty: never saved.
std::vector<ExportJob> jobs_of(const ExportPlan& plan, const Design& design, const std::string& draft_path,
                               const std::string& version);

struct ExportFigures {
  SetFigures set;                // of the first target; size and repeat are those of all
  float texels_a_thread = 0;     // of the system that has fewer
  int images = 0;                // of all sets
  int64_t texel_bytes = 0;       // on a graphics card, uncompressed, of all sets
  std::vector<std::string> why;  // what is amiss
};
ExportFigures figures_of(const Design& design, const std::vector<ExportJob>& jobs);

/// What is in the way of the jobs: other files than those of the same sets, a line each.
std::vector<std::string> in_the_way(const std::vector<ExportJob>& jobs);
/// Files of the same sets that stand there and will be replaced.
int replaced_files(const std::vector<ExportJob>& jobs);

/// The target is taken in or left out; one stays.
void toggle(ExportPlan& plan, ExportTarget target);

/// "14 MB"; for people.
std::string shown_bytes(int64_t bytes);

}  // namespace weftlight::session
