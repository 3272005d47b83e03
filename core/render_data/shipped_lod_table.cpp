#include "render_data/shipped_lod_table.h"

#include "base/files.h"
#include "base/resources.h"
#include "base/text.h"

namespace weftlight::render_data {

using base::FileBytes, base::arg, base::fill, base::message, base::presets_dir, base::read_file, base::tr;
using light::default_lod_table, light::read_lod_table;

ShippedLodTable shipped_lod_table() {
  constexpr uint64_t kMaxBytes = uint64_t{1} << 24;
  const std::string path = presets_dir() + "/lod_table.csv";
  const FileBytes file = read_file(path, kMaxBytes);
  std::string problem = file.error;
  if (problem.empty()) {
    base::Result<LodTable> read = read_lod_table(file.bytes);
    if (read && !read->empty()) return {std::move(*read), {}};
    problem = read ? tr("has no line that can be used") : message(read.error());
  }
  return {default_lod_table(), fill(tr("{file}: {problem}; methods are chosen by the built-in LOD table"),
                                    arg("file", path), arg("problem", problem))};
}

}  // namespace weftlight::render_data
