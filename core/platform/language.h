#pragma once
// The catalogue of what the user reads (gettext): which language it speaks, and look-up.

#include <string>

namespace weftlight::platform {

/// Chooses the language; call it before other threads start, the last call counts. `language` is a name as in `de` or
/// `pt_BR`; empty: that of the system. `folder` holds LANGUAGE/LC_MESSAGES/weftlight.mo. A language without a catalogue
/// reads English, which is the language of the sources.
void use_language(const std::string& language, const std::string& folder);

/// The text in the chosen language, or `text` itself. Lives as long as the program.
const char* translated(const char* text);
/// The same with a context that tells two equal English texts apart.
const char* translated(const char* context, const char* text);
/// By the plural rule of the language.
const char* translated(const char* one, const char* many, unsigned long count);

}  // namespace weftlight::platform
