// `print`: the draft on paper, as PDF, SVG or PNG. SVG and PNG hold one sheet per file.

#include <cstdio>
#include <filesystem>

#include "base/file_names.h"
#include "base/text.h"
#include "commands/commands.h"
#include "commands/file_options.h"
#include "commands/open_design.h"
#include "print/print.h"

namespace weftlight::commands {

using base::arg, base::fill, base::tr_n, base::write_file_atomically;

int print_command(const PrintCommand& options) {
  const OpenedDesign opened = open_design(options.file);
  if (!opened.ok) return kBadInput;
  const std::string extension = base::extension_of(options.out);
  const auto format = extension == ".pdf"   ? print::PrintFormat::kPdf
                      : extension == ".svg" ? print::PrintFormat::kSvg
                                            : print::PrintFormat::kPng;
  print::PrintOptions named = options.options;
  named.name = std::filesystem::path(options.file).stem().string();
  const base::Result<print::Printed> printed = print::printed(opened.design, format, named);
  if (!printed) return fail({printed.error().kind, printed.error().text, options.file});
  std::vector<std::string> sheets;
  for (size_t i = 0; i < printed->files.size(); ++i)
    sheets.push_back(print::sheet_file(options.out, i, printed->files.size()));
  for (const std::string& sheet : sheets)
    if (const std::string problem = replaces_input(sheet, {options.file}); !problem.empty()) return refuse(problem);
  for (size_t i = 0; i < sheets.size(); ++i) {
    if (const auto saved = write_file_atomically(sheets[i], printed->files[i]); !saved) return fail(saved.error());
  }
  const std::string line =
      fill(tr_n("{count} sheet", "{count} sheets", printed->sheets), arg("count", printed->sheets));
  std::printf("%s\n", line.c_str());
  return kDone;
}

}  // namespace weftlight::commands
