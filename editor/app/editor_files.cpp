// Files of the editor: recovery of unsaved work, changes by other programs, write errors, and the gallery.

#include <chrono>
#include <filesystem>
#include <utility>

#include "app/editor.h"
#include "base/text.h"
#include "base/user_folders.h"
#include "platform/folders.h"
#include "session/document/bring_back.h"
#include "session/library/gallery.h"

namespace weftlight::app {

using base::arg;
using base::fill;
using base::mark;
using base::tr;

namespace {

namespace fs = std::filesystem;

int64_t now_ns() {
  const auto since = std::chrono::system_clock::now().time_since_epoch();
  return std::chrono::duration_cast<std::chrono::nanoseconds>(since).count();
}

/// An unused name such as "twill-2.wif".
std::string free_name_beside(const std::string& path) {
  const fs::path file(path);
  std::error_code ignored;
  for (int n = 2;; ++n) {
    const fs::path beside =
        file.parent_path() / (file.stem().string() + "-" + std::to_string(n) + file.extension().string());
    if (!fs::exists(beside, ignored)) return beside.string();
  }
}

}  // namespace

void Editor::keep_live_export() {
  const std::string& path = options_.live_export;
  if (path.empty() || starting_) return;
  live_problem_.clear();
  if (same_file(path, document().path())) {
    live_problem_ = fill(tr("No live export: {path} is the open draft"), arg("path", path));
    return writer_.drop(path);
  }
  writer_.keep(path, [out = live_export_, make = document().writer()] {
    const std::string problem = out->write(make());
    return problem.empty()
               ? problem
               : fill(tr("No live export to {path}: {problem}"), arg("path", out->path()), arg("problem", problem));
  });
}

std::string Editor::trouble() const {
  std::string problem = session_.problem();
  if (problem.empty()) problem = live_problem_;
  return problem.empty() ? writer_.problem() : problem;
}

void Editor::look_at_file() {
  if (!no_dialog() || file_dialog_.waiting()) return;
  const OpenDocument& open = session_.active();
  if (open.document.path().empty() || saver_.saving(open.id)) return;
  struct Look {
    FileChange change;
    FileIdentity now;
  };
  base::Task task = base::task_with_result(
      [path = open.document.path(), known = open.document.file()](const base::RunningTask&) {
        FileIdentity now = known;
        const FileChange change = changed_since(path, now);
        return Look{change, now};
      },
      [this, id = open.id, known = open.document.file()](const Look& look) {
        OpenDocument* asked = session_.find(id);
        // Saved or read again meanwhile, or no longer shown: the next look counts.
        if (asked == nullptr || &session_.active() != asked || saver_.saving(id) || asked->document.file() != known)
          return;
        asked->document.accept(look.change == FileChange::kNone ? look.now : known);
        if (look.change == FileChange::kGone) take_gone(*asked);
        if (look.change == FileChange::kContent && no_dialog()) ask_about_change(false, nullptr);
      });
  task.kind = "look";
  reading_.start(std::move(task));
}

void Editor::take_gone(OpenDocument& open) {
  open.document.accept({});
  open.document.mark_unsaved();
  session_.keep_unsaved(open);
  say(fill(tr("{file} has been moved or deleted. Saving writes it again."), arg("file", open.document.name())));
  edited();
}

void Editor::ask_about_change(bool saving, std::function<void()> then) {
  const std::string text =
      document().is_saved() ? fill(tr("{path} is not what was opened or saved here."), arg("path", document().path()))
                            : fill(tr("{path} is not what was opened or saved here.\n\nReloading it loses your changes "
                                      "since the last save."),
                                   arg("path", document().path()));
  ask(Question{fill(tr("{file} was changed by another program"), arg("file", document().name())),
               text,
               {mark("Save a copy\xE2\x80\xA6"), mark("Keep mine"), mark("Reload"), mark("Cancel")}},
      [this, saving, then = std::move(then)](int button) {
        const std::string path = document().path();
        if (button == 0)
          ask_path(FileAsk::kSave, tr("Save your draft as a copy"), free_name_beside(path),
                   [this, then](const std::string& beside) { save_to(beside, false, then); });
        if (button == 1 && saving) save_to(path, true, then);
        if (button == 1 && !saving) {
          OpenDocument& open = session_.active();
          open.document.accept_file();
          open.document.mark_unsaved();
          session_.keep_unsaved(open);
          edited();
        }
        if (button == 2) read_again();
      });
}

void Editor::read_again() {
  const OpenDocument& open = session_.active();
  const std::string path = open.document.path();
  read(path, [this, path, id = open.id, before = open.document.snapshot()](OpenResult result) {
    if (!result.document) return report(std::move(result.remarks), path);
    const OpenDocument* asked = session_.find(id);
    if (asked == nullptr) return;
    const std::string name = asked->document.name();
    if (asked->document.snapshot() != before)
      return say(fill(tr("{file} was not reloaded, because you have edited it meanwhile"), arg("file", name)));
    session_.replace(id, std::move(*result.document), settings_.per_inch);
    say(fill(tr("Reloaded {file}"), arg("file", name)));
  });
}

void Editor::show_gallery(bool library) {
  GalleryPrompt prompt;
  prompt.page = library ? 1 : 0;
  prompt.recent = recent_cards(settings_.recent, platform::home_folder());
  prompt.library = library_cards();
  prompt.pictures = std::make_shared<GalleryPictures>(cache_folder() + "/drafts", Window::wake, now_ns());
  ask(std::move(prompt), [this](int button) {
    const GalleryCard card = std::get<GalleryPrompt>(dialog_).open;
    dialog_ = {};
    if (button == GalleryPrompt::kBrowse) return open();
    if (button == GalleryPrompt::kNew) return new_draft();
    if (card.copy) open_copy(card.path);
    else open_path(card.path);
  });
}

void Editor::offer_recovery() {
  if (session_.left().empty()) return;
  RecoveryPrompt prompt;
  for (const LeftWork& left : session_.left()) {
    const std::string when = time_in_words(left.written_ns, now_ns());
    if (!left.problem.empty()) prompt.rows.push_back({tr("Cannot be read"), when, left.journal + ": " + left.problem});
    else prompt.rows.push_back({left.note.name, when, left.note.path.empty() ? tr("never saved") : left.note.path});
  }
  ask(std::move(prompt), [this](int button) {
    const RecoveryPrompt& asked = std::get<RecoveryPrompt>(dialog_);
    const auto chosen = static_cast<size_t>(asked.chosen);
    switch (asked.button(button)) {
      case RecoveryPrompt::Button::kOne:
        return bring_back(chosen);
      case RecoveryPrompt::Button::kAll:
        return bring_back_all();
      case RecoveryPrompt::Button::kDiscard:
        session_.discard(chosen);
        return offer_recovery();
      case RecoveryPrompt::Button::kLater:
        return;
    }
  });
}

void Editor::bring_back(size_t chosen) {
  const LeftWork& left = session_.left()[chosen];
  const std::string& name = left.note.name;
  base::Task task = base::task_with_result([left](const base::RunningTask&) { return session::bring_back(left); },
                                           [this, left](OpenResult back) { take_back(left, std::move(back)); },
                                           [this, name](const std::string& why) {
                                             report({{Severity::kError, 0, why, {}}}, name);
                                           });
  task.kind = "left:" + left.journal;
  task.name = fill(tr("Recovering {draft}"), arg("draft", name));
  reading_.start(std::move(task));
}

void Editor::take_back(const LeftWork& left, OpenResult back) {
  if (!back.document) return report(std::move(back.remarks), left.note.name);
  if (session_.take_back(left, std::move(back), settings_.per_inch) == nullptr) return;
  if (document().path().empty() && !left.note.path.empty())
    say(fill(tr("{path} has changed or is gone. Saving asks for a place."), arg("path", left.note.path)));
  else if (!session_.left().empty()) say(tr("There is more to recover: File, Recover unsaved work"));
}

void Editor::bring_back_all() {
  // The newest is recovered last, so that it is shown; unreadable work stays.
  for (size_t left = session_.left().size(); left-- > 0;) bring_back(left);
}

}  // namespace weftlight::app
