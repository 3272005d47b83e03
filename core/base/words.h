#pragma once
// Words in lines of files.

#include <string_view>

namespace weftlight::base {

/// Whether both are the same but for the case of ASCII letters.
bool same_word(std::string_view a, std::string_view b);

/// Removes and returns the next word, between blanks or ends of lines; empty at the end.
std::string_view next_word(std::string_view& text);

}  // namespace weftlight::base
