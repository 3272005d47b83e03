#pragma once
// The line at the bottom: what is under the pointer, the draft in numbers, the remarks on the file.

#include <span>

#include "views/common/names.h"
#include "views/common/panel.h"
#include "wif/wif.h"

namespace weftlight::views {

/// `trouble` (empty: none) is what could not be written, and stands before all else; `message` is shown for a while
/// after something was done ("Saved"). True when the remarks were clicked.
bool draw_status_bar(PanelContext& c, const std::string& trouble, const std::string& message,
                     std::span<const Diagnostic> remarks);
/// "48 ends x 60 picks, 4 shafts, 6 treadles, rising".
std::string summary(const Draft& draft);

/// The remarks on the opened file in a window of their own, quiet: line, what, what to do.
void draw_remarks(PanelContext& c, std::span<const Diagnostic> remarks, bool& open);

}  // namespace weftlight::views
