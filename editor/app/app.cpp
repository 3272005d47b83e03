#include "app/app.h"

#include <cstdio>
#include <string>

#include "app/editor.h"
#include "app/window.h"
#include "base/text.h"
#include "base/user_folders.h"
#include "platform/file.h"
#include "session/files/file_identity.h"
#include "session/files/own_output.h"
#include "session/files/stale_files.h"

namespace weftlight::app {

using base::tr;
using commands::fail, commands::kDone, commands::refuse;
using session::Settings, session::load_settings;

namespace {

/// The flag that would replace a foreign file, and why; empty if all may be written.
std::string refused_flag(const EditorOptions& o) {
  const auto refusal = [](const char* flag, const std::string& path, const std::string& why) {
    return why.empty() ? why : std::string(flag) + " " + path + ": " + why;
  };
  std::string refused;
  if (!o.live_export.empty())
    refused = refusal("--live-export", o.live_export,
                      session::LiveExport(o.live_export, base::state_folder()).rejected_edit(o.file));
  if (refused.empty() && !o.ui_map.empty())
    refused = refusal("--ui-map", o.ui_map, session::ui_map_refusal(o.ui_map, o.file));
  if (refused.empty() && session::same_file(o.ui_map, o.live_export))
    refused = refusal("--ui-map", o.ui_map, tr("--live-export writes there; give two files"));
  return refused;
}

}  // namespace

int run_editor(const EditorOptions& options) {
  if (const std::string refused = refused_flag(options); !refused.empty()) return refuse(refused);
  platform::survive_size_limit();
  const Settings settings = load_settings();
  for (const std::string& file : {options.live_export, options.ui_map}) session::remove_stale_files(file);
  const auto window = Window::open(settings.width, settings.height);
  if (!window) return fail(window.error());
  Editor(**window, options).run();
  return kDone;
}

}  // namespace weftlight::app
