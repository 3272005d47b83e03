#include "app/live_export_writer.h"

#include "base/text.h"
#include "base/user_folders.h"

namespace weftlight::app {

using base::arg, base::fill, base::state_folder, base::tr;
using session::same_file;

LiveExportWriter::LiveExportWriter(const std::string& path)
    : out_(std::make_shared<LiveExport>(path, state_folder())) {}

void LiveExportWriter::keep(const Document& document) {
  const std::string& path = out_->path();
  if (path.empty()) return;
  refused_.clear();
  if (same_file(path, document.path())) {
    refused_ = fill(tr("No live export: {path} is the open draft"), arg("path", path));
    return writer_.drop(path);
  }
  writer_.keep(path, [out = out_, make = document.writer()]() -> base::Result<void> {
    base::Result<void> written = out->write(make());
    if (written) return written;
    return base::failure(base::ErrorKind::kOutput,
                         fill(tr("No live export to {path}: {problem}"), arg("path", out->path()),
                              arg("problem", written.error().text)));
  });
}

}  // namespace weftlight::app
