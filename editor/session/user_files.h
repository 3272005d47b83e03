#pragma once
// The user's own files beside the drafts: settings, and copies for recovery after a crash.

#include <string>
#include <vector>

#include "session/background_writer.h"
#include "session/document.h"
#include "session/names.h"

namespace weftlight::session {

struct Settings {
  bool dark = false, end1_right = true;
  int drawdown_style = 0;
  bool per_inch = false;            // ends and picks are counted in an inch
  float split = 0;                  // share of the window that the draft takes; 0: what it fills
  int width = 1440, height = 900;   // of the window
  std::vector<std::string> recent;  // newest first
};
/// $XDG_CONFIG_HOME/weftlight/settings.json; what is missing or wrong is as in Settings{}.
Settings load_settings();
void save_settings(const Settings& settings);
void remember(Settings& settings, const std::string& path);

/// A copy of unsaved work that a crash left behind.
struct LeftBehind {
  std::string copy;  // the .wif
  std::string path;  // the file it belongs to; empty: never saved
};

/// Copies of unsaved work in $XDG_STATE_HOME/weftlight/recovery, named after the process.
class ProcessRecovery {
 public:
  ProcessRecovery();
  /// Writes the document's copy; removes it when there is nothing unsaved.
  void keep(BackgroundWriter& writer, const Document& document) const;
  void forget(BackgroundWriter& writer) const;
  /// Copies whose process is no more.
  std::vector<LeftBehind> left_behind() const;
  static void discard(BackgroundWriter& writer, const LeftBehind& left);

 private:
  std::string folder_, copy_, name_;
};

}  // namespace weftlight::session
