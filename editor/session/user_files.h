#pragma once
// The user's settings.

#include <string>
#include <string_view>
#include <vector>

#include "session/names.h"

namespace weftlight::session {

struct Settings {
  bool dark = false, end1_right = true;
  int drawdown_style = 0;
  bool per_inch = false;            // ends and picks are counted in an inch
  bool inspector = true;            // is shown
  int inspector_tab = 0;            // of this run; not kept
  float split = 0;                  // share of the window that the draft takes; 0: what it fills
  int width = 1440, height = 900;   // of the window
  std::vector<std::string> recent;  // newest first
};
/// $XDG_CONFIG_HOME/weftlight/settings.json; what is missing or wrong is as in Settings{}.
Settings load_settings();
/// The file's text, and back: any bytes are read, and whatever a path is made of is written as UTF-8 JSON.
Settings settings_from(std::string_view json);
std::string settings_text(const Settings& settings);
void save_settings(const Settings& settings);
void remember(Settings& settings, const std::string& path);

}  // namespace weftlight::session
