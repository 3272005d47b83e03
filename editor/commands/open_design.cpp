#include <cstdio>

#include "commands/commands.h"
#include "files/picture_draft.h"
#include "wif/other_formats.h"

namespace weftlight::commands {
void print_diagnostic(const std::string& path, const Diagnostic& d) {
  const std::string place = d.line > 0 ? path + ":" + std::to_string(d.line) : path;
  std::fprintf(stderr, "%s: %s%s; %s\n", place.c_str(),
               d.severity == Severity::kError ? "" : "warning: ", d.text.c_str(), d.remedy.c_str());
}

int not_written(const std::string& why) {
  std::fprintf(stderr, "%s; choose another place\n", why.c_str());
  return kNotWritten;
}

OpenedDesign open_design(const std::string& path, bool print_warnings, const files::PictureDraft& picture) {
  OpenedDesign result;
  const FileBytes file = read_file(path);
  if (!file.error.empty()) {
    std::fprintf(stderr, "%s: %s; give the path of a draft\n", path.c_str(), file.error.c_str());
    return result;
  }
  WifRead read = is_picture(path) ? read_picture_draft(path, picture) : read_draft(file.bytes);
  for (const Diagnostic& d : read.diagnostics) {
    const bool warning = print_warnings && d.severity == Severity::kWarning;
    if (d.severity == Severity::kError || warning) print_diagnostic(path, d);
  }
  result.diagnostics = std::move(read.diagnostics);
  if (!read.file) return result;
  result.ok = true;
  result.design = read.file->design;
  result.file = std::move(*read.file);
  return result;
}

}  // namespace weftlight::commands
