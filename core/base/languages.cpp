#include "base/languages.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <optional>
#include <system_error>
#include <utility>

#include "base/text.h"

namespace weftlight::base {
namespace fs = std::filesystem;

namespace {

constexpr const char* kEnglish = "en";
constexpr std::array<std::pair<const char*, const char*>, 8> kOwnNames = {{{kEnglish, "English"},
                                                                           {"de", "Deutsch"},
                                                                           {"es", "Espa\xC3\xB1ol"},
                                                                           {"fi", "Suomi"},
                                                                           {"fr",
                                                                            "Fran\xC3\xA7"
                                                                            "ais"},
                                                                           {"ja", mark("Nihongo")},
                                                                           {"nl", "Nederlands"},
                                                                           {"sv", "Svenska"}}};

std::string own_name(const std::string& code) {
  for (const auto& [known, name] : kOwnNames)
    if (code == known) return tr(name);  // Nihongo: only its own window has the letters
  return code;
}

fs::path catalogue(const fs::path& folder, const std::string& code) {
  return folder / code / "LC_MESSAGES" / "weftlight.mo";
}

/// Texts of a compiled catalogue, without its header. Source: GNU gettext manual, The Format of GNU MO Files.
std::optional<uint32_t> texts_of(const fs::path& file) {
  constexpr uint32_t kMagic = 0x950412de;
  std::array<uint32_t, 3> head{};  // what it is, the revision of the format, the number of texts
  std::array<char, sizeof head> bytes{};
  if (!std::ifstream(file, std::ios::binary).read(bytes.data(), bytes.size())) return std::nullopt;
  std::memcpy(head.data(), bytes.data(), bytes.size());
  if (head[0] != kMagic || head[2] == 0) return std::nullopt;
  return head[2] - 1;
}

int percent_of(uint32_t translated, uint32_t all) {
  if (translated >= all) return 100;
  return static_cast<int>(std::min<uint64_t>(99, uint64_t{translated} * 100 / all));
}

}  // namespace

bool is_language_name(std::string_view text) {
  constexpr size_t kMaxLetters = 40;
  const auto allowed = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '@' ||
           c == '-' || c == '.';
  };
  return !text.empty() && text.size() <= kMaxLetters && text[0] != '-' && text[0] != '.' &&
         std::all_of(text.begin(), text.end(), allowed);
}

bool has_language(const std::string& folder, std::string_view name) {
  if (!is_language_name(name)) return false;
  for (std::string code(name); !code.empty();) {
    // C and POSIX are the texts as they are in the sources.
    if (code == kEnglish || code == "C" || code == "POSIX" || texts_of(catalogue(folder, code))) return true;
    const size_t last = code.find_last_of("_.@");
    code.resize(last == std::string::npos ? 0 : last);
  }
  return false;
}

std::vector<Language> installed_languages(const std::string& folder) {
  std::vector<Language> found;
  const std::optional<uint32_t> all = texts_of(catalogue(folder, kEnglish));
  std::error_code error;
  for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
    const std::string code = at->path().filename().string();
    if (code == kEnglish || !is_language_name(code)) continue;
    const std::optional<uint32_t> texts = texts_of(catalogue(folder, code));
    if (texts) found.push_back({code, own_name(code), all ? percent_of(*texts, *all) : 100});
  }
  std::sort(found.begin(), found.end(), [](const Language& a, const Language& b) { return a.name < b.name; });
  found.insert(found.begin(), Language{kEnglish, own_name(kEnglish), 100});
  return found;
}

std::string shown_name(const Language& language) {
  if (language.percent >= 100) return language.name;
  return fill(tr("{language} (unfinished, {percent}%)"), arg("language", language.name),
              arg("percent", language.percent));
}

}  // namespace weftlight::base
