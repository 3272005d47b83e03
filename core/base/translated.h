#pragma once
// Texts in the user's language, looked up in the catalogue (text.h has how they are filled).

#include <string>

#include "platform/language.h"

namespace weftlight::base {

/// The text in the user's language; lives as long as the program.
inline const char* tr(const char* text) { return platform::translated(text); }
/// With a context for translators where one English text has two meanings, as "Draft" the noun and the verb.
inline const char* tr_in(const char* context, const char* text) { return platform::translated(context, text); }
/// By the plural rule of the language; `many` is the English plural. Counts below 0 read as their size.
const char* tr_n(const char* one, const char* many, long long count);
/// Of a figure as it is shown, which may have decimals: only "1" is one.
const char* tr_n(const char* one, const char* many, const std::string& shown);

}  // namespace weftlight::base
