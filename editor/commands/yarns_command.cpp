// `yarns`: the yarns of drafts and of lists, printed or written as one list.

#include <cstdio>
#include <utility>

#include "base/file_names.h"
#include "base/text.h"
#include "commands/commands.h"
#include "commands/open_design.h"
#include "design/fibre.h"
#include "design/written_count.h"
#include "design/yarn_library.h"

namespace weftlight::commands {

using base::arg, base::fill, base::read_file, base::tr, base::tr_n, base::write_file_atomically;
using design::LibraryYarn, design::YarnLibrary, design::fibre_name, design::kMaxLibraryBytes, design::library_yarn_of,
    design::read_yarn_library, design::with_library_yarn, design::written_count, design::yarn_library_text;

namespace {

/// The yarns of a list; its remarks are printed.
base::Result<std::vector<LibraryYarn>> of_list(const std::string& path) {
  const base::Result<std::string> text = read_file(path, kMaxLibraryBytes);
  if (!text) return failed(text);
  base::Result<YarnLibrary> list = read_yarn_library(*text);
  if (!list) return base::failure(list.error().kind, list.error().text, path, list.error().line);
  for (const design::LibraryRemark& remark : list->remarks)
    std::fprintf(stderr, "%s:%d: %s\n", path.c_str(), remark.line, remark.text.c_str());
  return std::move(list->yarns);
}

std::string yarn_row(const LibraryYarn& y) {
  const std::string count = y.count.empty() ? written_count(y.yarn) : y.count;
  std::string row = count + ", " + tr(fibre_name(y.yarn.fibre));
  if (!y.colors.empty()) {
    const auto colors = static_cast<long long>(y.colors.size());
    row += ", " + fill(tr_n("{count} colour", "{count} colours", colors), arg("count", colors));
  }
  if (y.price > 0 && y.cone_m > 0)
    row += ", " + fill(tr("{price:.2f} / {size:.0f} m"), arg("price", y.price), arg("size", y.cone_m));
  else if (y.price > 0 && y.cone_g > 0)
    row += ", " + fill(tr("{price:.2f} / {size:.0f} g"), arg("price", y.price), arg("size", y.cone_g));
  else if (y.price > 0) row += ", " + fill(tr("{price:.2f} /kg"), arg("price", y.price));
  return row;
}

}  // namespace

int yarns_command(const YarnsOptions& options) {
  YarnLibrary all;
  for (const std::string& path : options.files) {
    if (base::extension_of(path) == ".txt") {
      const auto list = of_list(path);
      if (!list) return fail(list.error());
      for (const LibraryYarn& yarn : *list) all.yarns = with_library_yarn(std::move(all.yarns), yarn);
      continue;
    }
    const OpenedDesign opened = open_design(path);
    if (!opened.ok) return kBadInput;
    for (size_t i = 0; i < opened.design.yarns.size(); ++i)
      all.yarns = with_library_yarn(std::move(all.yarns), library_yarn_of(opened.design, static_cast<int>(i), -1));
  }
  if (!options.out.empty()) return finish(write_file_atomically(options.out, yarn_library_text(all)));
  for (const LibraryYarn& yarn : all.yarns) print_row(yarn.yarn.name, yarn_row(yarn));
  return kDone;
}

}  // namespace weftlight::commands
