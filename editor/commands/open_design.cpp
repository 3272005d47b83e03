#include "commands/open_design.h"

#include <cstdio>

#include "base/text.h"
#include "base/whole_files.h"
#include "commands/exit_codes.h"
#include "files/picture_draft.h"
#include "wif/other_formats.h"

namespace weftlight::commands {

using analysis::LongestFloats;
using base::ErrorKind, base::arg, base::fill, base::read_file, base::tr, base::tr_n;
using files::is_picture, files::read_picture_draft;
using wif::Diagnostic, wif::Severity, wif::WifRead, wif::kMaxDraftBytes, wif::read_draft;

void print_diagnostic(const std::string& path, const Diagnostic& d) {
  const std::string file = d.line > 0 ? path + ":" + std::to_string(d.line) : path;
  const char* form =
      d.severity == Severity::kError ? tr("{file}: {problem}; {remedy}") : tr("{file}: warning: {problem}; {remedy}");
  const std::string line = fill(form, arg("file", file), arg("problem", d.text), arg("remedy", d.remedy));
  std::fprintf(stderr, "%s\n", line.c_str());
}

void print_row(const std::string& label, const std::string& value) {
  constexpr size_t kColumn = 16;  // characters
  size_t width = 0;
  for (const char c : label) width += (static_cast<unsigned char>(c) & 0xC0) != 0x80 ? 1 : 0;  // the heads of UTF-8
  const std::string gap(width < kColumn ? kColumn - width : 1, ' ');
  std::printf("%s%s%s\n", label.c_str(), gap.c_str(), value.c_str());
}

std::string threads_text(int ends, int picks) {
  return fill(tr("{ends}, {picks}"), arg("ends", fill(tr_n("{count} end", "{count} ends", ends), arg("count", ends))),
              arg("picks", fill(tr_n("{count} pick", "{count} picks", picks), arg("count", picks))));
}

std::string longest_float_text(const LongestFloats& floats) {
  return fill(tr("warp {warp_front} front, {warp_back} back; weft {weft_front} front, {weft_back} back"),
              arg("warp_front", floats.warp_front), arg("warp_back", floats.warp_back),
              arg("weft_front", floats.weft_front), arg("weft_back", floats.weft_back));
}

OpenedDesign open_design(const std::string& path, bool print_warnings, const files::PictureDraft& picture) {
  OpenedDesign result;
  const base::Result<std::string> file = read_file(path, is_picture(path) ? base::kMaxFileBytes : kMaxDraftBytes);
  if (!file) {
    fail({ErrorKind::kInput, fill(tr("{problem}; give the path of a draft"), arg("problem", file.error().text)), path});
    return result;
  }
  WifRead read = is_picture(path) ? read_picture_draft(path, picture) : read_draft(*file);
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
