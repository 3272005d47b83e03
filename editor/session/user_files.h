#pragma once
// The user's settings: what all documents of the window are seen with.

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "session/names.h"

namespace weftlight::session {

enum class DrawdownStyle { kThreads, kColor, kStructure };

/// What stands beside the preview: the ray-traced picture behind a slider, or how far the two are apart.
enum class Compare { kOff, kSplit, kDifference };

inline constexpr float kMaxLoomWasteCm = 1000, kMaxShare = 0.6f;
inline constexpr float kMinPictureMs = 5, kMaxPictureMs = 5000;

struct Settings {
  bool dark = false, end1_right = true;
  bool pick1_bottom = false;     // picks are read upwards, as they are woven
  bool threading_below = false;  // the drawdown, with shaft 1 next to it; else above
  bool minimap = true;           // of a drawdown that is not all in sight
  bool tiled = false;            // the drawdown goes on beyond its edges
  bool show_repeat = false;      // outlined in the drawdown
  DrawdownStyle drawdown_style = DrawdownStyle::kThreads;
  int heavy_lines = 5;                      // a heavier line of the grids every so many threads; 0: none
  bool per_inch = false;                    // ends and picks are counted in an inch
  bool inspector = true;                    // is shown
  float split = 0;                          // share of the window that the draft takes; 0: what it fills
  int width = 1440, height = 900;           // of the window
  std::vector<std::string> recent;          // newest first
  std::string loom_address;                 // of the loom that was last sent to
  std::map<std::string, std::string> keys;  // by action: the shortcut that the weaver gave it; empty: none
  float loom_waste_cm = 60, shrinkage = 0.08f, spare_yarn = 0.05f;  // of the yarn that a cloth needs; shares
  std::map<std::string, float> yarn_prices;                         // of a kilogram, by the yarn's name
  bool by_time = false;    // the picture of the cloth takes so long, whatever its error
  float picture_ms = 60;   // then: milliseconds of its cloth's pass
  bool start_page = true;  // what was open lately is shown at the start
  bool toured = false;     // has seen the tour, or left it
  // Of the window while it stands; not kept.
  int tour = -1;  // its step; -1: it is not shown
  int inspector_tab = 0;
  bool show_history = false;
  bool show_methods = false;  // false colours: which method shades which pixel
  Compare compare = Compare::kOff;
  float compare_split = 0.5f;  // of the pane's width
  float lobe_light_deg = 35;   // of the light in the plot of the lobes, from the normal
};
/// $XDG_CONFIG_HOME/weftlight/settings.json; what is missing or wrong is as in Settings{}.
Settings load_settings();
/// The file's text, and back: any bytes are read, and whatever a path is made of is written as UTF-8 JSON.
Settings settings_from(std::string_view json);
std::string settings_text(const Settings& settings);
void save_settings(const Settings& settings);
void remember(Settings& settings, const std::string& path);
/// No longer among those that were open lately.
void forget(Settings& settings, const std::string& path);

}  // namespace weftlight::session
