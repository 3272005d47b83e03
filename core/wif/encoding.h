#pragma once
// Text of WIF files: UTF-8 where the bytes are valid UTF-8, otherwise Latin-1 as Windows writes it
// (code page 1252 as the WHATWG Encoding Standard tables it: every byte means a character).

#include <optional>
#include <string>
#include <string_view>

namespace weftlight::wif {

enum class Encoding { kUtf8, kLatin1 };

/// Converts bytes of the given encoding to UTF-8.
std::string to_utf8(std::string_view bytes, Encoding from);
/// Converts UTF-8 to the given encoding; empty if a character is missing in it.
std::optional<std::string> from_utf8(std::string_view text, Encoding to);
/// Converts UTF-8 to ASCII: drops accents, simplifies quotes and dashes; other characters become '?'.
std::string to_ascii(std::string_view text);
/// Escapes line ends, backslashes, controls and invalid UTF-8 as \n, \\ and \xNN; and back.
std::string escaped(std::string_view text);
std::string unescaped(std::string_view text);
/// One trimmed line of valid UTF-8; control characters become blanks.
std::string one_line(std::string_view text);

}  // namespace weftlight::wif
