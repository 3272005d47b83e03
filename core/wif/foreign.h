#pragma once
// What the readers of other programs' files share.

#include <string>

#include "wif/other_formats.h"
#include "wif/parse.h"

namespace weftlight::wif {

inline constexpr size_t kMaxForeignBytes = size_t{1} << 26;

std::string quoted(std::string_view text);
Rgb color_of_bytes(int r, int g, int b, int most);
/// UTF-8 of text that is UTF-8 or Latin-1, cut to a line of 1,000 bytes.
std::string text_of_foreign(std::string_view text);
/// The file as if it had been a WIF, with what was found.
WifRead foreign_file(std::optional<WifFile> file, const char* format, Diagnostics& diagnostics);

}  // namespace weftlight::wif
