// `print`: the draft on paper, as PDF, SVG or PNG; a sheet a file where the format holds one.

#include <cstdio>
#include <filesystem>

#include "commands/commands.h"
#include "print/print.h"

namespace weftlight::commands {

int print_command(const PrintCommand& options) {
  const bool pdf = options.out.ends_with(".pdf"), svg = options.out.ends_with(".svg");
  if (!pdf && !svg && !options.out.ends_with(".png")) {
    std::fprintf(stderr, "%s: this cannot be printed to; give a name that ends in .pdf, .svg or .png\n",
                 options.out.c_str());
    return kUsage;
  }
  const OpenedDesign opened = open_design(options.file);
  if (!opened.ok) return kBadInput;
  const auto format = pdf ? print::PrintFormat::kPdf : svg ? print::PrintFormat::kSvg : print::PrintFormat::kPng;
  print::PrintOptions how = options.options;
  how.name = std::filesystem::path(options.file).stem().string();
  const print::Printed printed = print::printed(opened.design, format, how);
  if (!printed.why.empty()) {
    std::fprintf(stderr, "%s: %s\n", options.file.c_str(), printed.why.c_str());
    return kBadInput;
  }
  for (size_t i = 0; i < printed.files.size(); ++i) {
    const std::string path = print::sheet_file(options.out, i, printed.files.size());
    const std::string error = write_file_atomically(path, printed.files[i]);
    if (!error.empty()) return not_written(error);
  }
  std::printf("%d sheets\n", printed.sheets);
  return kDone;
}

}  // namespace weftlight::commands
