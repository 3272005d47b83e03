#pragma once
// Drafts as other programs save them: .dtx (Fiberworks) and .wpo (WeavePoint). Their format is known from outside
// alone; what is not understood is listed as a remark. The result is a WIF file that was never saved: its bytes are
// those of a new WIF of the design.

#include <string_view>

#include "wif/wif.h"

namespace weftlight::wif {

enum class DraftFormat { kWif, kDtx, kWpo };

/// By the first bytes; what is neither .dtx nor .wpo is taken for WIF.
DraftFormat format_of(std::string_view bytes);

/// By the ending of a file's name, whatever its case: .wif, .wifw; and .dtx, .wpo.
bool is_wif_name(std::string_view path);
bool is_draft_name(std::string_view path);

WifRead read_dtx(std::string_view bytes);
WifRead read_wpo(std::string_view bytes);
/// Whichever it is.
WifRead read_draft(std::string_view bytes);

}  // namespace weftlight::wif
