#pragma once
// The languages of the window: which catalogues are there, by their own names, and how far each is translated.

#include <string>
#include <string_view>
#include <vector>

namespace weftlight::base {

struct Language {
  std::string code;   // "de", "pt_BR"
  std::string name;   // in that language: "Deutsch"; the code if it is not known
  int percent = 100;  // of the texts that are translated; 99 at most while one is missing
};

/// Letters, digits, _ @ - and dots, not first: nothing that leads out of the folder of catalogues.
bool is_language_name(std::string_view text);
/// True for English and for a language whose catalogue is there, which may be that of a shorter name: "de" for "de_AT"
/// or "de_AT.UTF-8".
bool has_language(const std::string& folder, std::string_view name);
/// English, then those of FOLDER/CODE/LC_MESSAGES/weftlight.mo by their names. The catalogue of English says how many
/// texts there are.
std::vector<Language> installed_languages(const std::string& folder);
/// "Deutsch", or "Suomi (unfinished, 80 %)".
std::string shown_name(const Language& language);

}  // namespace weftlight::base
