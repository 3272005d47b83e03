// The Help menu.

#include "actions/action_parts.h"
#include "base/languages.h"
#include "base/resources.h"

namespace weftlight::actions {

using base::Language, base::fill, base::installed_languages, base::mark, base::shown_name, base::tr;
using session::Settings;

namespace {

/// Texts are looked up while the window is drawn and on other threads: another language waits for the next start.
void add_languages(Actions& all, const WindowActions& window, Settings& settings) {
  const auto language = [&](const std::string& code, const std::string& label, const std::string& said) {
    Action& a = add(all, "Help", ("language." + code).c_str(), label.c_str(), "", [&settings, &window, code, said] {
      settings.language = code;
      window.say(said);
    });
    a.item.submenu = mark("Language");
    a.checked = [&settings, code] { return settings.language == code; };
  };
  language("", tr("System language"), tr("Weftlight will use the system language from the next start."));
  for (const Language& each : installed_languages(base::languages_dir()))
    language(
        each.code, shown_name(each),
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
