#pragma once
// Text of WIF files: UTF-8 where the bytes are valid UTF-8, otherwise Latin-1 as Windows writes it
// (code page 1252 as the WHATWG Encoding Standard tables it: every byte means a character).

#include <optional>
#include <string>
#include <string_view>

#include "wif/names.h"

namespace weftlight::wif {

enum class Encoding { kUtf8, kLatin1 };

/// Bytes of the given encoding to UTF-8.
std::string to_utf8(std::string_view bytes, Encoding from);
/// UTF-8 to the given encoding; empty when it has no such character.
std::optional<std::string> from_utf8(std::string_view text, Encoding to);
/// UTF-8 to ASCII: accents dropped, quotes and dashes made plain, the rest '?'.
std::string to_ascii(std::string_view text);
/// Anything that is not one line of plain UTF-8 text as \n, \\ or \xNN; and back.
std::string escaped(std::string_view text);
std::string unescaped(std::string_view text);
/// The one-line form of a text: controls become blanks, ends trimmed, valid UTF-8.
std::string one_line(std::string_view text);

}  // namespace weftlight::wif
