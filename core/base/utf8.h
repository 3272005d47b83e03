#pragma once
// Valid UTF-8 from any bytes, for JSON and for the window.

#include <cstdint>
#include <string>
#include <string_view>

namespace weftlight::base {

/// Length in bytes of the valid UTF-8 sequence at the start of `text`, with its code point in `code`; 0 if there is
/// none.
size_t utf8_sequence(std::string_view text, uint32_t& code);
bool is_utf8(std::string_view text);
/// The text with each byte that is not part of a character replaced by U+FFFD.
std::string as_utf8(std::string_view text);
/// The start of `text`, at most `bytes` long, cut between characters.
std::string_view cut_utf8(std::string_view text, size_t bytes);
/// The letters A to Z that stand for a Latin letter with marks or a ligature, as "o" for U+00F6 and "ae" for U+00E6;
/// empty for all else, ASCII too.
std::string plain_latin(uint32_t code);

}  // namespace weftlight::base
