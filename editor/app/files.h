#pragma once
// The files of the open drafts: open, save, notice what other programs do to them, and open them again.

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "app/dialogs.h"
#include "app/live_export_writer.h"
#include "app/messages.h"
#include "app/names.h"
#include "session/session.h"
#include "session/user_files.h"

namespace weftlight::app {

class Files {
 public:
  /// `edited` is called when the shown document changed without an edit.
  Files(Session& session, Settings& settings, Dialogs& dialogs, Messages& messages, LiveExportWriter& live_export,
        std::function<void()> edited);

  /// The document that the window starts with, and that replaces the last one.
  static Document first_document();
  /// Opens the document in a tab beside the others.
  void open_beside(Document document, Origin origin);
  void open();
  void open_path(const std::string& path);
  void open_copy(const std::string& path);
  void duplicate();

  void save() { save_shown(nullptr); }
  void save_as();
  void save_for_others();
  void save_all() { save_each(session_.unsaved(), nullptr); }
  /// Saves the shown draft, asking for a path if it has none. Runs `then` only if it was saved.
  void save_shown(std::function<void()> then);
  /// Saves several. Runs `then` only if all were saved.
  void save_each(std::vector<uint64_t> ids, const std::function<void()>& then);

  /// Checks the file when the window or tab becomes active; asks if another program changed it.
  void look_at_file();
  void reload();
  void show_in_folder();

 private:
  const Document& document() const { return session_.active().document; }
  void save_to(const std::string& path, const std::function<void()>& then);
  /// Saves to the document's own file; asks if another program changed it.
  void save_own(std::function<void()> then);
  void ask_about_change(bool saving, std::function<void()> then);
  /// Keeps the document as it is, though the disk holds something else.
  void keep_mine();
  /// Reads the file of the shown document again.
  void read_again();

  Session& session_;
  Settings& settings_;
  Dialogs& dialogs_;
  Messages& messages_;
  LiveExportWriter& live_export_;
  std::function<void()> edited_;
};

}  // namespace weftlight::app
