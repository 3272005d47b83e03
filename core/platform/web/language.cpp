// There is no gettext: the program speaks English, the language of its sources.

#include "platform/language.h"

#include "platform/catalogue.h"

namespace weftlight::platform {

void use_language(const std::string& /*language*/, const std::string& /*folder*/) {}
std::string catalogue_language() { return {}; }
const char* translated(const char* text) { return text; }
const char* translated(const char* /*context*/, const char* text) { return text; }
const char* translated(const char* one, const char* many, unsigned long count) { return count == 1 ? one : many; }

}  // namespace weftlight::platform
