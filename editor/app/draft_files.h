#pragma once
// The files of the open drafts: open, save, notice what other programs do to them, and open them again.

#include <cstdint>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "app/background_tasks.h"
#include "app/dialogs.h"
#include "app/live_export_writer.h"
#include "app/messages.h"
#include "session/files/user_files.h"
#include "session/saver.h"
#include "session/session.h"

namespace weftlight::app {

using session::Document, session::FileIdentity, session::OpenResult, session::Origin, session::SaveResult,
    session::Saver, session::Session, session::Settings;

class Files {
 public:
  /// `edited` is called when the shown document changed without an edit.
  Files(Session& session, Settings& settings, BackgroundTasks& tasks, Dialogs& dialogs, Messages& messages,
        LiveExportWriter& live_export, std::function<void()> edited);

  /// The document that the window starts with, and that replaces the last one.
  static Document first_document();
  /// Opens the document in a tab beside the others.
  void open_beside(Document document, Origin origin);
  /// On the loom of the last plan.
  void open_new(design::Design design);
  void open();
  void open_path(const std::string& path);
  void open_copy(const std::string& path);
  void duplicate();
  /// Reads a draft beside the window; `then` gets it, or why there is none.
  void read(const std::string& path, std::function<void(OpenResult)> then);
  /// Opens the drafts that the program was started with, the last one in front.
  void start_with(const std::vector<std::string>& paths);
  /// True until they are open, or cannot be.
  bool starting() const { return !starting_.empty(); }
  /// The user cancelled what is read as a task of this kind.
  void cancel(const std::string& kind);
  /// Writes the shown draft to the file of --live-export.
  void keep_live_export();

  void save() { save_shown(nullptr); }
  void save_as();
  void save_for_others();
  void save_all() { save_each(session_.unsaved(), nullptr); }
  /// Saves the shown draft, asking for a path if it has none. Runs `then` only if it was saved.
  void save_shown(const std::function<void()>& then);
  /// Saves several. Runs `then` only if all were saved.
  void save_each(std::vector<uint64_t> ids, const std::function<void()>& then);

  /// The saves in progress.
  Saver& saver() { return saver_; }
  const Saver& saver() const { return saver_; }

  /// Checks the file when the window or tab becomes active; asks if another program changed it.
  void look_at_file();
  void reload();
  void show_in_folder();

 private:
  const Document& document() const { return session_.active().document; }
  /// Saves beside the window; `then` runs when the draft is on the disk. `over_changes`: also over those of another
  /// program.
  void save_to(const std::string& path, bool over_changes, const std::function<void()>& then);
  void saved(uint64_t id, const std::string& path, const SaveResult& result, const std::function<void()>& then);
  void tell_not_saved(uint64_t id, const std::string& problem);
  /// Writes what `make` returns and says so.
  void write(const std::string& path, std::function<std::string()> make);
  /// `on_disk`: the file as another program left it, if it was noticed before a save.
  void ask_about_change(const std::optional<FileIdentity>& on_disk, std::function<void()> then);
  /// Keeps the shown document as it is, though the disk holds something else: this file, or none.
  void keep_mine(const FileIdentity& on_disk);
  /// Reads the file of the shown document again.
  void read_again();
  /// What is read as a task of this kind is open, or cannot be.
  void end_start(const std::string& kind);

  Session& session_;
  Settings& settings_;
  BackgroundTasks& tasks_;
  Dialogs& dialogs_;
  Messages& messages_;
  LiveExportWriter& live_export_;
  std::function<void()> edited_;
  Saver saver_;
  std::set<std::string> starting_;  // kinds of the tasks that read what the program was started with
};

}  // namespace weftlight::app
