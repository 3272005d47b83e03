#pragma once
// Text for those who take UTF-8 alone (JSON, the window).

#include <cstdint>
#include <string>
#include <string_view>

namespace weftlight::base {

/// Bytes of the valid UTF-8 sequence at the head of `text`, its code point in `code`; 0: there is none.
size_t utf8_sequence(std::string_view text, uint32_t& code);
bool is_utf8(std::string_view text);
/// The same text where it is UTF-8; each byte that is part of no character becomes U+FFFD.
std::string as_utf8(std::string_view text);
/// The head of `text`, at most `bytes` long, cut between characters.
std::string_view cut_utf8(std::string_view text, size_t bytes);

}  // namespace weftlight::base
