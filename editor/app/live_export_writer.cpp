#include "app/live_export_writer.h"

#include "base/text.h"
#include "base/user_folders.h"

namespace weftlight::app {

using base::arg, base::fill, base::state_folder, base::tr;
using session::facts_of, session::is_one_file, session::is_same_name;

namespace {

std::string is_the_draft(const std::string& path) {
  return fill(tr("No live export: {path} is the open draft"), arg("path", path));
}

}  // namespace

LiveExportWriter::LiveExportWriter(const std::string& path)
    : out_(std::make_shared<LiveExport>(path, state_folder())) {}

void LiveExportWriter::keep(const Document& document) {
  const std::string& path = out_->path();
  if (path.empty()) return;
  refused_.clear();
  if (is_same_name(path, document.path())) {
    refused_ = is_the_draft(path);
    return writer_.drop(path);
  }
  writer_.keep(path, [out = out_, draft = document.file(), make = document.writer()]() -> base::Result<void> {
    if (is_one_file(facts_of(out->path()), draft))  // by another name
      return base::failure(base::ErrorKind::kOutput, is_the_draft(out->path()));
    base::Result<void> written = out->write(make());
    if (written) return written;
    return base::failure(base::ErrorKind::kOutput,
                         fill(tr("No live export to {path}: {problem}"), arg("path", out->path()),
                              arg("problem", written.error().text)));
  });
}

}  // namespace weftlight::app
