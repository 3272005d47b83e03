#include "platform/language.h"

#include <algorithm>
#include <list>

#include "platform/catalogue.h"
#include "platform/environment_variables.h"
#include "platform/file.h"
#include "platform/without_gettext/compiled_catalogue.h"
#include "platform/without_gettext/system_language.h"

namespace weftlight::platform {
namespace {

/// Texts that were given out live as long as the program, and so does every catalogue that was once chosen.
struct Catalogues {
  std::list<CompiledCatalogue> all;
  const CompiledCatalogue* chosen = nullptr;  // null: English
};
Catalogues& catalogues() {
  static Catalogues& kept = *new Catalogues;
  return kept;
}

/// Empty if it cannot be read.
std::string bytes_of(const std::string& path) {
  constexpr size_t kMaxBytes = size_t{16} << 20;
  std::string bytes;
  std::error_code error;
  File file(path, File::Open::kRead);
  if (file.error() || file.facts().kind != FileKind::kRegular) return {};
  char part[65536];
  while (const size_t got = file.read(part, sizeof part, error)) {
    bytes.append(part, got);
    if (bytes.size() > kMaxBytes) return {};
  }
  return bytes;
}

/// The variables that gettext asks, in its order.
std::string wanted_language() {
  for (const char* name : {"LANGUAGE", "LC_ALL", "LC_MESSAGES", "LANG"})
    if (std::string value = variable(name); !value.empty()) return value.substr(0, value.find(':'));
  return system_language();
}

}  // namespace

void use_language(const std::string& language, const std::string& folder) {
  Catalogues& kept = catalogues();
  kept.chosen = nullptr;
  std::string name = language.empty() ? wanted_language() : language;
  std::replace(name.begin(), name.end(), '-', '_');
  name.resize(std::min(name.size(), name.find('.')));
  // "de_AT", then "de".
  for (; !name.empty(); name.resize(name.find('_') == std::string::npos ? 0 : name.rfind('_'))) {
    std::string bytes = bytes_of(folder + "/" + name + "/LC_MESSAGES/weftlight.mo");
    if (bytes.empty()) continue;
    kept.chosen = &kept.all.emplace_back(std::move(bytes));
    return;
  }
}

std::string catalogue_language() {
  const CompiledCatalogue* chosen = catalogues().chosen;
  return chosen != nullptr ? chosen->field("Language") : "";
}

const char* translated(const char* text) {
  const CompiledCatalogue* chosen = catalogues().chosen;
  const char* found = chosen != nullptr && *text != '\0' ? chosen->text(text) : nullptr;
  return found != nullptr && *found != '\0' ? found : text;
}

const char* translated(const char* context, const char* text) {
  const CompiledCatalogue* chosen = catalogues().chosen;
  // The key of a text with a context, as msgfmt writes it.
  const char* found = chosen != nullptr ? chosen->text(std::string(context) + '\004' + text) : nullptr;
  return found != nullptr ? found : text;
}

const char* translated(const char* one, const char* many, unsigned long count) {
  const CompiledCatalogue* chosen = catalogues().chosen;
  const char* found = chosen != nullptr ? chosen->text(one, count) : nullptr;
  return found != nullptr ? found : count == 1 ? one : many;
}

}  // namespace weftlight::platform
