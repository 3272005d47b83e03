#pragma once
// A program of the system that speaks a text aloud.

#include <string>
#include <vector>

namespace weftlight::platform {

/// The name of the first one that is installed; empty: none.
std::string speaking_program();
/// The words that start it: it says `text` in `language` ("de", or "C" for English), and ends.
std::vector<std::string> speaking_words(const std::string& program, const std::string& text,
                                        const std::string& language);

}  // namespace weftlight::platform
