#include "app/start_dialogs.h"

#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <utility>

#include "app/window.h"
#include "base/text.h"
#include "base/user_folders.h"
#include "platform/folders.h"
#include "session/document/bring_back.h"
#include "session/library/gallery.h"

namespace weftlight::app {

using actions::GalleryPage;
using base::arg, base::cache_folder, base::fill, base::tr;
using session::GalleryCard, session::OpenDocument, session::library_cards, session::name_of, session::recent_cards,
    session::time_in_words;
using views::GalleryPictures, views::GalleryPrompt, views::RecoveryPrompt;
using wif::Severity;

namespace {

int64_t now_ns() {
  const auto since = std::chrono::system_clock::now().time_since_epoch();
  return std::chrono::duration_cast<std::chrono::nanoseconds>(since).count();
}

}  // namespace

StartDialogs::StartDialogs(Session& session, Files& files, Settings& settings, BackgroundTasks& tasks, Dialogs& dialogs,
                           Messages& messages, std::function<void()> new_draft)
    : session_(session),
      files_(files),
      settings_(settings),
      tasks_(tasks),
      dialogs_(dialogs),
      messages_(messages),
      new_draft_(std::move(new_draft)) {}

void StartDialogs::begin(bool gallery) {
  base::Task task = base::task_with_result(
      [&session = session_](const base::RunningTask&) {
        return Found{session.find_left(), session::crash_reports_in(session::recovery_folder())};
      },
      [this, gallery](base::Result<Found> found) {
        if (found) take_found(std::move(*found), gallery);
        else
          messages_.say(
              fill(tr("The search for unsaved work failed: {problem}"), arg("problem", message(found.error()))));
      });
  task.kind = "left";
  tasks_.computing().start(std::move(task));
}

void StartDialogs::take_found(Found found, bool gallery) {
  session_.set_left(std::move(found.work));
  crashes_ = std::move(found.crashes);
  if (has_left_work()) dialogs_.when_none([this] { offer_recovery(); });
  else if (gallery && !dialogs_.any())
    show_gallery(settings_.recent.empty() ? GalleryPage::kLibrary : GalleryPage::kRecent);
}

void StartDialogs::delete_reports() {
  base::Task task;
  task.work = [crashes = std::exchange(crashes_, {})](const base::RunningTask&) { session::remove_reports(crashes); };
  task.finishes = true;
  tasks_.writing().start(std::move(task));
}

void StartDialogs::show_gallery(GalleryPage page) {
  GalleryPrompt prompt;
  prompt.page = static_cast<int>(page);
  if (!browser_) browser_ = std::make_shared<FolderBrowser>(collection::index_folder(), Window::wake);
  if (browser_->folder().empty() && !settings_.drafts_folder.empty()) browser_->open(settings_.drafts_folder);
  prompt.browser = browser_;
  prompt.filter = filter_;
  prompt.recent = recent_cards(settings_.recent, platform::home_folder());
  prompt.library = library_cards();
  prompt.pictures = std::make_shared<GalleryPictures>(cache_folder() + "/drafts", Window::wake, now_ns());
  dialogs_.ask(std::move(prompt), [this](int button) {
    const GalleryCard card = dialogs_.prompt<GalleryPrompt>().open;
    filter_ = dialogs_.prompt<GalleryPrompt>().filter;
    dialogs_.close();
    if (button == GalleryPrompt::kFolder) return choose_folder();
    if (button == GalleryPrompt::kBrowse) return files_.open();
    if (button == GalleryPrompt::kNew) return new_draft_();
    if (card.copy) files_.open_copy(card.path);
    else files_.open_path(card.path);
  });
}

void StartDialogs::choose_folder() {
  dialogs_.ask_path(FileAsk::kFolder, tr("Folder of drafts"), settings_.drafts_folder,
                    [this](const std::string& folder) {
                      settings_.drafts_folder = folder;
                      browser_->open(folder);
                      show_gallery(GalleryPage::kFolder);
                    });
}

void StartDialogs::offer_recovery() {
  if (!has_left_work()) return;
  RecoveryPrompt prompt;
  prompt.reports = session::joined_text(crashes_);
  for (const LeftWork& left : session_.left()) {
    const std::string when = time_in_words(left.written_ns, now_ns());
    if (!left.note) prompt.rows.push_back({tr("Cannot be read"), when, message(left.note.error())});
    else
      prompt.rows.push_back({name_of(*left.note), when, left.note->path.empty() ? tr("never saved") : left.note->path});
  }
  dialogs_.ask(std::move(prompt), [this](int button) {
    const auto& asked = dialogs_.prompt<RecoveryPrompt>();
    const auto chosen = static_cast<size_t>(asked.chosen);
    switch (asked.button(button)) {
      case RecoveryPrompt::Button::kOne:
        return bring_back(chosen);
      case RecoveryPrompt::Button::kAll:
        return bring_back_all();
      case RecoveryPrompt::Button::kDiscard:
        session_.discard(chosen);
        return offer_recovery();
      case RecoveryPrompt::Button::kDeleteReports:
        delete_reports();
        return offer_recovery();
      case RecoveryPrompt::Button::kLater:
        return;
    }
  });
}

void StartDialogs::bring_back(size_t chosen) {
  const LeftWork& left = session_.left()[chosen];
  const std::string name = name_of(left);
  base::Task task =
      base::task_with_result([left](const base::RunningTask&) { return session::bring_back(left); },
                             [this, left, name](base::Result<OpenResult> back) {
                               if (back) take_back(left, std::move(*back));
                               else messages_.report({{Severity::kError, 0, message(back.error()), {}}}, name);
                             });
  task.kind = "left:" + left.journal;
  task.name = fill(tr("Recovering {draft}"), arg("draft", name));
  task.may_be_left = true;
  tasks_.reading().start(std::move(task));
}

void StartDialogs::take_back(const LeftWork& left, OpenResult back) {
  if (!back.document) return messages_.report(std::move(back.remarks), name_of(left));
  const OpenDocument* open = session_.take_back(left, std::move(back));
  if (open == nullptr) return;
  const std::string path = left.note ? left.note->path : "";
  if (open->document.path().empty() && !path.empty())
    messages_.say(fill(tr("{path} has changed or was deleted. Saving will ask for a location."), arg("path", path)));
  else if (!session_.left().empty())
    messages_.say(tr("More unsaved work can be recovered: File > Recover unsaved work"));
}

void StartDialogs::bring_back_all() {
  // The newest is recovered last, so that it is shown; unreadable work stays.
  for (size_t left = session_.left().size(); left-- > 0;) bring_back(left);
}

}  // namespace weftlight::app
