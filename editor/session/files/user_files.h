#pragma once
// The user's settings, shared by all documents of the window.

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "design/design.h"
#include "draft/heavy_lines.h"

namespace weftlight::session {

enum class DrawdownStyle { kThreads, kColor, kStructure };

/// Comparison with the ray-traced reference: split by a slider, or the difference.
enum class Compare { kOff, kSplit, kDifference };

/// Sizes of the interface that the View menu offers, in percent of the size that the screen asks for.
inline constexpr int kInterfaceSizes[] = {80, 90, 100, 110, 125, 150, 175, 200};

/// Ranges of the true distance: from the cloth, of the eyes from the screen, and of a screen's window units in a mm.
inline constexpr float kNearestSeen_m = 0.3f, kFurthestSeen_m = 5;
inline constexpr float kNearestEye_cm = 20, kFurthestEye_cm = 200;
inline constexpr float kMinPx_a_mm = 0.5f, kMaxPx_a_mm = 40;

inline constexpr float kMinPictureMs = 5, kMaxPictureMs = 5000;

struct Settings {
  bool dark = false, end1_right = true;
  bool pick1_bottom = false;     // picks run upwards, as they are woven
  bool threading_below = false;  // below the drawdown, shaft 1 next to it; else above
  bool minimap = true;           // shown if the drawdown is not fully visible
  bool tiled = false;            // the drawdown repeats beyond its edges
  bool show_repeat = false;      // outlined in the drawdown
  bool rulers = false;           // in cm or inches, at the drawdown and at the flat cloth
  DrawdownStyle drawdown_style = DrawdownStyle::kThreads;
  int heavy_lines = draft::kHeavyLines;          // a heavier grid line every n threads; 0: none
  float seen_from_m = 1;                         // how far the true distance takes the weaver from the cloth
  float eye_to_screen_cm = 50;                   // and how far their eyes are from the screen
  std::map<std::string, float> screens;          // calibrated: window units in a millimetre, by the screen's name
  bool imperial = false;                         // inches, yards, ounces and pounds; ends and picks per inch
  bool cloth = true;                             // the cloth is computed and shown beside the draft
  bool inspector = true;                         // the inspector is shown
  float split = 0;                               // fraction of the width for the draft; 0 fits it
  int width = 1440, height = 900;                // of the window
  int interface_percent = 100;                   // of the size of texts and controls that the screen asks for
  std::string language;                          // of the window, as "de"; empty: that of the system
  std::vector<std::string> recent;               // paths, most recent first
  std::string drafts_folder;                     // that is browsed in the gallery; empty: none yet
  std::string loom_address;                      // of the loom last connected
  bool say_steps = false;                        // each new step at the loom is spoken
  std::map<std::string, std::string> keys;       // shortcuts set by the user, by action id; empty: none
  float loom_waste_cm = 60, spare_yarn = 0.05f;  // last planned, for the next new draft; the second is a fraction
  std::map<std::string, float> yarn_prices;      // last planned, of a kilogram, by yarn name
  bool by_time = false;                          // time budget instead of an error tolerance
  float picture_ms = 60;                         // that budget, for the pass of the cloth
  bool start_page = true;                        // the gallery opens at the start
  bool toured = false;                           // the tour was finished or skipped
  // State of the open window; not saved.
  int tour = -1;  // step of the tour; -1 if it is not shown
  int inspector_tab = 0;
  bool show_history = false;
  bool show_methods = false;  // false colours by shading method
  Compare compare = Compare::kOff;
  float compare_split = 0.5f;  // fraction of the pane width
  float lobe_light_deg = 35;   // angle of the light in the plot of the lobes, from the normal
};
/// $XDG_CONFIG_HOME/weftlight/settings.json; missing or invalid values are as in Settings{}.
Settings load_settings();
/// Reads and writes the text of the file. Any bytes can be read; any path can be written as UTF-8 JSON.
Settings settings_from(std::string_view json);
std::string settings_text(const Settings& settings);
void save_settings(const Settings& settings);
void remember(Settings& settings, const std::string& path);
/// The loom waste and spare yarn of the plan become those of new drafts, and its prices are offered for their yarns.
void remember_plan(Settings& settings, const design::ClothPlan& plan);
/// A new draft on the loom for which the last was planned.
design::Design with_usual_plan(design::Design draft, const Settings& settings);
/// Removes the path from the recent files.
void forget(Settings& settings, const std::string& path);

}  // namespace weftlight::session
