#include "render_data/shipped_lod_table.h"

#include "base/files.h"
#include "base/resources.h"

namespace weftlight::render_data {

ShippedLodTable shipped_lod_table() {
  constexpr uint64_t kMaxBytes = uint64_t{1} << 24;
  const std::string path = presets_dir() + "/lod_table.csv";
  const FileBytes file = read_file(path, kMaxBytes);
  ShippedLodTable shipped{{}, file.error};
  if (file.error.empty()) shipped.lod_table = read_lod_table(file.bytes, shipped.problem);
  if (shipped.problem.empty() && shipped.lod_table.empty()) shipped.problem = "has no line that can be used";
  if (shipped.problem.empty()) return shipped;
  return {default_lod_table(), path + ": " + shipped.problem + "; methods are chosen by the built-in ladder"};
}

}  // namespace weftlight::render_data
