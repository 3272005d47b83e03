#pragma once
// Shared by the readers of other programs' formats.

#include <string>

#include "wif/other_formats.h"
#include "wif/parse.h"

namespace weftlight::wif {

using draft::Rgb;

inline constexpr size_t kMaxForeignBytes = size_t{1} << 26;

std::string quoted(std::string_view text);
/// Without the blanks around it, and no more than its beginning.
std::string short_quote(std::string_view text);
Rgb color_of_bytes(int r, int g, int b, int most);
/// Text in UTF-8 or Latin-1 as one line of UTF-8 of at most 1,000 bytes.
std::string text_of_foreign(std::string_view text);
/// The result of a reader: the file, with the bytes of a new WIF of its design, and the diagnostics.
WifRead foreign_file(std::optional<WifFile> file, const char* format, Diagnostics& diagnostics);

}  // namespace weftlight::wif
