#pragma once
// For tables of texts (text.h), without the cost of fmt in every file that includes such a table.

namespace weftlight::base {

/// Only tells the catalogue of a text that is looked up later.
constexpr const char* mark(const char* text) { return text; }

}  // namespace weftlight::base
