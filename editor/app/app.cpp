#include "app/app.h"

#include <chrono>
#include <cstdlib>
#include <memory>
#include <optional>
#include <string>
#include <system_error>
#include <thread>
#include <utility>

#include "app/editor.h"
#include "app/window.h"
#include "base/caught.h"
#include "base/file_names.h"
#include "base/resources.h"
#include "base/text.h"
#include "base/user_folders.h"
#include "commands/built_commit.h"
#include "platform/catalogue.h"
#include "platform/crash_report.h"
#include "platform/file.h"
#include "platform/language.h"
#include "platform/missing_font.h"
#include "platform/turns.h"
#include "session/files/own_output.h"
#include "session/files/stale_files.h"
#include "session/recovery/recovery.h"

namespace weftlight::app {

using base::tr;
using commands::fail, commands::kDone, commands::print_problem;
using session::Settings, session::load_settings;

namespace {

/// An error of this option if the result is one.
base::Result<void> of_option(const char* option, const base::Result<void>& result) {
  if (result) return {};
  return base::failure(result.error().kind, std::string(option) + " " + message(result.error()));
}

/// An error if an option would replace a file that is not its own.
base::Result<void> check_options(const EditorOptions& o) {
  base::Result<void> fine;
  if (!o.live_export.empty())
    fine = of_option("--live-export", session::LiveExport(o.live_export, base::state_folder()).check(o.files));
  if (fine && !o.ui_map.empty()) fine = of_option("--ui-map", session::check_ui_map(o.ui_map, o.files));
  if (fine && base::same_file(o.ui_map, o.live_export))
    fine = of_option(
        "--ui-map", base::failure(base::ErrorKind::kUsage, tr("--live-export writes there; give two files"), o.ui_map));
  return fine;
}

/// After the window system went away. The work of the editor, if there is one yet, is on the disk first.
[[noreturn]] void end_without_window(Editor* editor) {
  int code = commands::kNoGraphics;
  const base::Result<void> done = base::caught([&] {
    bool unsaved = false;
    const std::string problem = editor != nullptr ? editor->keep_work(unsaved) : std::string();
    if (unsaved) code = commands::kNotWritten;
    if (!problem.empty()) print_problem(problem);
    print_problem(unsaved ? tr("the display server or graphics driver has stopped; unsaved work is kept and can be "
                               "recovered at the next start")
                          : tr("the display server or graphics driver has stopped"));
  });
  if (!done) code = commands::kNotWritten;
  // Without the ends of threads and libraries: those that draw would ask for the window system.
  std::_Exit(code);
}

/// As long as it lives, the work of the editor is kept if the window system goes away.
class KeepsWork {
 public:
  explicit KeepsWork(Editor& editor) {
    Window::when_lost([&editor] { end_without_window(&editor); });
  }
  ~KeepsWork() {
    Window::when_lost([] { end_without_window(nullptr); });
  }
  KeepsWork(const KeepsWork&) = delete;
  KeepsWork& operator=(const KeepsWork&) = delete;
};

/// All is on the disk by now, and a window system that goes away meanwhile is nobody's loss. GLFW asks the desktop's
/// clipboard manager to keep what was copied, and waits for its answer without an end.
void end_soon() {
  static constexpr std::chrono::seconds kPatience{3};
  Window::when_lost([] { std::_Exit(commands::kDone); });
  try {
    std::thread([] {
      std::this_thread::sleep_for(kPatience);
      std::_Exit(commands::kDone);
    }).detach();
  } catch (const std::system_error&) {  // without a thread it waits for the manager
  }
}

/// The window with its editor. Where a browser gives the turns, nothing else keeps them.
class OpenedEditor {
 public:
  OpenedEditor(std::unique_ptr<Window> window, const EditorOptions& options)
      : window_(std::move(window)), editor_(std::make_unique<Editor>(*window_, options)) {
    keeps_work_.emplace(*editor_);
  }

  bool turn() {
    if (editor_->turn()) return true;
    editor_->leave();
    keeps_work_.reset();
    editor_.reset();
    end_soon();
    return false;
  }

 private:
  std::unique_ptr<Window> window_;
  std::unique_ptr<Editor> editor_;
  std::optional<KeepsWork> keeps_work_;
};

/// A language without a font for its letters could not be read: the window is in English then. What it says of that.
std::string use_readable_language() {
  const std::string font = platform::missing_font(platform::catalogue_language());
  if (font.empty()) return {};
  platform::use_language("en", base::languages_dir());
  return base::fill(base::tr("No installed font has the letters of your language, so the window is in English. Install "
                             "{font} and start again."),
                    base::arg("font", font));
}

}  // namespace

int run_editor(const EditorOptions& options) {
  if (const base::Result<void> fine = check_options(options); !fine) return fail(fine.error());
  platform::report_crashes(session::recovery_folder(), "Weftlight " + commands::version_and_commit());
  const Settings settings = load_settings();
  if (!options.language_asked && !settings.language.empty())
    platform::use_language(settings.language, base::languages_dir());
  EditorOptions readable = options;
  readable.notice = use_readable_language();
  for (const std::string& file : {options.live_export, options.ui_map}) session::remove_stale_files(file);
  auto window = Window::open(settings.width, settings.height);
  if (!window) return fail(window.error());
  Window::when_lost([] { end_without_window(nullptr); });
  const auto opened = std::make_shared<OpenedEditor>(std::move(*window), readable);
  platform::take_turns([opened] { return opened->turn(); });
  return kDone;
}

}  // namespace weftlight::app
