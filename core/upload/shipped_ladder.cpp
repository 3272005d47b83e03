#include "upload/shipped_ladder.h"

#include "base/files.h"
#include "base/resources.h"

namespace weftlight::upload {

ShippedLadder shipped_ladder() {
  constexpr uint64_t kMostBytes = uint64_t{1} << 24;
  const std::string path = presets_dir() + "/ladder.csv";
  const FileBytes file = read_file(path, kMostBytes);
  ShippedLadder shipped{{}, file.error};
  if (file.error.empty()) shipped.ladder = read_ladder(file.bytes, shipped.problem);
  if (shipped.problem.empty() && shipped.ladder.empty()) shipped.problem = "has no line that can be used";
  if (shipped.problem.empty()) return shipped;
  return {default_ladder(), path + ": " + shipped.problem + "; methods are chosen by the built-in ladder"};
}

}  // namespace weftlight::upload
