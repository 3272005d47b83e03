#include "platform/language.h"

#include <libintl.h>

#include <clocale>
#include <cstring>

#include "platform/catalogue.h"
#include "platform/environment_variables.h"

namespace weftlight::platform {
namespace {

constexpr const char* kDomain = "weftlight";

/// gettext asks the catalogue only where the locale is another than "C"; C.UTF-8 is one on every system.
void leave_c_locale() {
  const char* now = std::setlocale(LC_MESSAGES, "");
  if (now == nullptr || std::strcmp(now, "C") == 0 || std::strcmp(now, "POSIX") == 0)
    std::setlocale(LC_MESSAGES, "C.UTF-8");
}

}  // namespace

void use_language(const std::string& language, const std::string& folder) {
  if (!language.empty()) {
    set_variable("LANGUAGE", language);
    leave_c_locale();
  } else {
    std::setlocale(LC_MESSAGES, "");
  }
  ::bindtextdomain(kDomain, folder.c_str());
  ::bind_textdomain_codeset(kDomain, "UTF-8");
  ::textdomain(kDomain);
}

std::string catalogue_language() {
  // The text of no text is the header of the catalogue, or nothing.
  const std::string header = ::gettext("");
  constexpr const char* kField = "\nLanguage: ";
  const size_t at = header.find(kField);
  if (at == std::string::npos) return {};
  const size_t from = at + std::strlen(kField);
  return header.substr(from, header.find('\n', from) - from);
}

const char* translated(const char* text) { return *text == '\0' ? text : ::gettext(text); }

const char* translated(const char* context, const char* text) {
  // The key of a text with a context, as msgfmt writes it. gettext returns the key itself where it is not found.
  const std::string key = std::string(context) + '\004' + text;
  const char* found = ::gettext(key.c_str());
  return found == key.c_str() ? text : found;
}

const char* translated(const char* one, const char* many, unsigned long count) { return ::ngettext(one, many, count); }

}  // namespace weftlight::platform
