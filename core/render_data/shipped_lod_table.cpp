#include "render_data/shipped_lod_table.h"

#include "base/resources.h"
#include "base/text.h"
#include "base/whole_files.h"

namespace weftlight::render_data {

using base::arg, base::fill, base::presets_dir, base::read_file, base::tr;
using light::default_lod_table, light::read_lod_table;

namespace {

base::Result<LodTable> table_in(const std::string& path) {
  constexpr uint64_t kMaxBytes = uint64_t{1} << 24;
  const base::Result<std::string> text = read_file(path, kMaxBytes);
  if (!text) return failed(text);
  base::Result<LodTable> read = read_lod_table(*text);
  if (read && read->empty()) return base::failure(base::ErrorKind::kInput, tr("has no line that can be used"), path);
  if (!read) return base::failure(base::ErrorKind::kInput, read.error().text, path, read.error().line);
  return read;
}

}  // namespace

ShippedLodTable shipped_lod_table() {
  const std::string path = presets_dir() + "/lod_table.csv";
  base::Result<LodTable> read = table_in(path);
  if (read) return {std::move(*read), {}};
  base::Error why = std::move(read).error();
  why.text = fill(tr("{problem}; methods are chosen by the built-in LOD table"), arg("problem", why.text));
  return {default_lod_table(), base::Failure(std::move(why))};
}

}  // namespace weftlight::render_data
