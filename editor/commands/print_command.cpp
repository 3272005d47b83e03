// `print`: the draft on paper, as PDF, SVG or PNG. SVG and PNG hold one sheet per file.

#include <cstdio>
#include <filesystem>

#include "base/text.h"
#include "commands/commands.h"
#include "commands/open_design.h"
#include "print/print.h"

namespace weftlight::commands {

using base::ErrorKind, base::arg, base::fill, base::tr, base::tr_n, base::write_file_atomically;

int print_command(const PrintCommand& options) {
  const bool pdf = options.out.ends_with(".pdf"), svg = options.out.ends_with(".svg");
  if (!pdf && !svg && !options.out.ends_with(".png")) {
    return fail(
        {ErrorKind::kUsage, tr("not a format for print; give a name that ends in .pdf, .svg or .png"), options.out});
  }
  const OpenedDesign opened = open_design(options.file);
  if (!opened.ok) return kBadInput;
  const auto format = pdf ? print::PrintFormat::kPdf : svg ? print::PrintFormat::kSvg : print::PrintFormat::kPng;
  print::PrintOptions named = options.options;
  named.name = std::filesystem::path(options.file).stem().string();
  const base::Result<print::Printed> printed = print::printed(opened.design, format, named);
  if (!printed) return fail({ErrorKind::kInput, printed.error().text, options.file});
  for (size_t i = 0; i < printed->files.size(); ++i) {
    const std::string path = print::sheet_file(options.out, i, printed->files.size());
    if (const auto saved = write_file_atomically(path, printed->files[i]); !saved) return fail(saved.error());
  }
  const std::string line =
      fill(tr_n("{count} sheet", "{count} sheets", printed->sheets), arg("count", printed->sheets));
  std::printf("%s\n", line.c_str());
  return kDone;
}

}  // namespace weftlight::commands
