#pragma once
// What the window may start with: the gallery of recent drafts and of the library, or unsaved work of crashed sessions
// with the reports of the crashes. Both can also be asked for later.

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "actions/file_actions.h"
#include "app/background_tasks.h"
#include "app/dialogs.h"
#include "app/draft_files.h"
#include "app/messages.h"
#include "session/files/user_files.h"
#include "session/recovery/crash_reports.h"
#include "session/session.h"

namespace weftlight::app {

using session::CrashReport, session::FolderBrowser, session::LeftWork, session::OpenResult, session::Session,
    session::Settings;

class StartDialogs {
 public:
  /// `new_draft` asks for a new draft.
  StartDialogs(Session& session, Files& files, Settings& settings, BackgroundTasks& tasks, Dialogs& dialogs,
               Messages& messages, std::function<void()> new_draft);
  /// Looks for work of crashed sessions and reports, and offers them; if there are none, shows the gallery if that is
  /// wanted.
  void begin(bool gallery);
  void show_gallery(actions::GalleryPage page);
  void choose_folder();
  void offer_recovery();
  bool has_left_work() const { return !session_.left().empty() || !crashes_.empty(); }

 private:
  struct Found {
    std::vector<LeftWork> work;
    std::vector<CrashReport> crashes;
  };
  void take_found(Found found, bool gallery);
  void delete_reports();
  void bring_back(size_t left);
  void bring_back_all();
  void take_back(const LeftWork& left, OpenResult back);

  Session& session_;
  Files& files_;
  Settings& settings_;
  BackgroundTasks& tasks_;
  Dialogs& dialogs_;
  Messages& messages_;
  std::function<void()> new_draft_;
  std::vector<CrashReport> crashes_;
  std::shared_ptr<FolderBrowser> browser_;  // null until the gallery is shown
  collection::DraftQuery filter_;           // of the folder, as it was left
};

}  // namespace weftlight::app
