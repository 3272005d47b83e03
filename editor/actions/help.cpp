// The Help menu.

#include <map>
#include <string>

#include "actions/action_parts.h"
#include "base/languages.h"
#include "base/resources.h"
#include "platform/missing_font.h"

namespace weftlight::actions {

using base::Language, base::arg, base::fill, base::installed_languages, base::mark, base::shown_name, base::tr;
using session::Settings;

namespace {

/// Asked once a language: to look through the installed fonts takes its time.
const std::string& missing_font(const std::string& language) {
  static std::map<std::string, std::string> known;
  const auto [at, is_new] = known.try_emplace(language);
  if (is_new) at->second = platform::missing_font(language);
  return at->second;
}

/// With the font that it lacks.
std::string label_of(const Language& language) {
  const std::string& font = missing_font(language.code);
  if (font.empty()) return shown_name(language);
  return fill(tr("{language}: first install the font {font}"), arg("language", language.name), arg("font", font));
}

/// Texts are looked up while the window is drawn and on other threads: another language waits for the next start.
void add_languages(Actions& all, const WindowActions& window, Settings& settings) {
  const auto language = [&](const std::string& code, const std::string& label, const std::string& said) {
    Action& a = add(all, "Help", ("language." + code).c_str(), label.c_str(), "", [&settings, &window, code, said] {
      settings.language = code;
      window.say(said);
    });
    a.item.submenu = mark("Language");
    a.checked = [&settings, code] { return settings.language == code; };
    if (!missing_font(code).empty()) a.enabled = [] { return false; };
  };
  language("", tr("System language"), tr("Weftlight will use the system language from the next start."));
  for (const Language& each : installed_languages(base::languages_dir()))
    language(
        each.code, label_of(each),
        fill(tr("From the next start, the window will be in this language: {language}"), arg("language", each.name)));
}

}  // namespace

void add_help_actions(Actions& all, const WindowActions& window, Settings& settings) {
  add(all, "Help", "tour", tr("Tour in five steps"), "", [&settings] { settings.tour = 0; });
  add(all, "Help", "menus", tr("Open the menus with the keyboard"), "F10", window.open_menus);
  add(all, "Help", "keys", tr("Keys and mouse"), "F1", window.toggle_keys);
  add(all, "Help", "handbook", tr("Handbook"), "Shift+F1", window.show_handbook);
  add_languages(all, window, settings);
}

}  // namespace weftlight::actions
