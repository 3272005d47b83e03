#include "app/app.h"

#include <cstdlib>
#include <string>

#include "app/editor.h"
#include "app/window.h"
#include "base/caught.h"
#include "base/text.h"
#include "base/user_folders.h"
#include "platform/file.h"
#include "session/files/file_identity.h"
#include "session/files/own_output.h"
#include "session/files/stale_files.h"

namespace weftlight::app {

using base::tr;
using commands::fail, commands::kDone, commands::print_problem, commands::refuse;
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

/// After the window system went away. The work of the editor, if there is one yet, is on the disk first.
[[noreturn]] void end_without_window(Editor* editor) {
  int code = commands::kNoGraphics;
  const std::string thrown = base::caught([&] {
    bool unsaved = false;
    const std::string problem = editor != nullptr ? editor->keep_work(unsaved) : std::string();
    if (unsaved) code = commands::kNotWritten;
    if (!problem.empty()) print_problem(problem);
    print_problem(unsaved ? tr("the window system or its graphics driver has gone; the unsaved work is kept, and the "
                               "next start offers it")
                          : tr("the window system or its graphics driver has gone"));
  });
  if (!thrown.empty()) code = commands::kNotWritten;
  // Without the ends of threads and libraries: those that draw would ask for the window system.
  std::_Exit(code);
}

}  // namespace

int run_editor(const EditorOptions& options) {
  if (const std::string refused = refused_flag(options); !refused.empty()) return refuse(refused);
  platform::survive_size_limit();
  const Settings settings = load_settings();
  for (const std::string& file : {options.live_export, options.ui_map}) session::remove_stale_files(file);
  const auto window = Window::open(settings.width, settings.height);
  if (!window) return fail(window.error());
  Window::when_lost([] { end_without_window(nullptr); });
  Editor editor(**window, options);
  Window::when_lost([&editor] { end_without_window(&editor); });
  editor.run();
  Window::when_lost([] { end_without_window(nullptr); });
  return kDone;
}

}  // namespace weftlight::app
