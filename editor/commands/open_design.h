#pragma once
// Drafts that a verb opens, with their problems on stderr, and the lines of reports.

#include <string>
#include <vector>

#include "analysis/floats.h"
#include "design/design.h"
#include "files/picture_draft.h"
#include "wif/wif.h"

namespace weftlight::commands {

using design::Design;
using wif::Diagnostic, wif::WifFile;

struct OpenedDesign {
  bool ok = false;
  Design design;
  WifFile file;
  std::vector<Diagnostic> diagnostics;
};
/// "file:line: what; what to do" on stderr.
void print_diagnostic(const std::string& path, const Diagnostic& diagnostic);
/// "4 ends, 1 pick"
std::string threads_text(int ends, int picks);
std::string longest_float_text(const analysis::LongestFloats& floats);
/// Prints a line of a report, its values in one column; labels and values are in the user's language.
void print_row(const std::string& label, const std::string& value);
/// Reads a draft and prints its problems on stderr; not `ok` if it cannot be used. `picture`: how a picture becomes a
/// draft.
OpenedDesign open_design(const std::string& path, bool print_warnings = false, const files::PictureDraft& picture = {});

}  // namespace weftlight::commands
