#pragma once
// Suggestions for mistyped words.

#include <span>
#include <string>

namespace weftlight::commands {

/// The word with the fewest different letters; empty if none is similar. Most letters of `typed` must be right.
std::string closest_word(const std::string& typed, std::span<const std::string> words);

}  // namespace weftlight::commands
