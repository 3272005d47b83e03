#pragma once
// Reads drafts of other programs: .dtx (Fiberworks) and .wpo (WeavePoint). Their formats are not published; what is not
// understood is listed as a note. The result is an unsaved WIF file: its bytes are those of a new WIF of the design.

#include <string_view>

#include "wif/wif.h"

namespace weftlight::wif {

enum class DraftFormat { kWif, kDtx, kWpo };

/// Detected from the first bytes; everything else counts as WIF.
DraftFormat format_of(std::string_view bytes);

/// By the ending of a file's name, whatever its case: .wif, .wifw; and .dtx, .wpo.
bool is_wif_name(std::string_view path);
bool is_draft_name(std::string_view path);

WifRead read_dtx(std::string_view bytes);
WifRead read_wpo(std::string_view bytes);
/// Reads any of these formats.
WifRead read_draft(std::string_view bytes);

}  // namespace weftlight::wif
