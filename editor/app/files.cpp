#include "app/files.h"

#include <filesystem>
#include <utility>

#include "app/open_folder.h"
#include "base/text.h"
#include "draft/generators/table.h"
#include "session/stale_files.h"

namespace weftlight::app {

using base::arg;
using base::fill;
using base::mark;
using base::tr;

namespace {

namespace fs = std::filesystem;

/// The path that a save dialog starts with.
std::string first_path(const Document& document) {
  if (!document.path().empty()) return document.path();
  return document.is_named() ? document.name() : "untitled.wif";
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

Files::Files(Session& session, Settings& settings, Dialogs& dialogs, Messages& messages, LiveExportWriter& live_export,
             std::function<void()> edited)
    : session_(session),
      settings_(settings),
      dialogs_(dialogs),
      messages_(messages),
      live_export_(live_export),
      edited_(std::move(edited)) {}

Document Files::first_document() {
  OpenResult starter = open_document(presets_dir() + "/drafts/starter.wif");
  if (!starter.document) return Document(draft::new_draft(*find_weave("straight"), {}, {48, 48}).design);
  // Unnamed, so that saving asks where.
  Document& d = *starter.document;
  return Document(d.now());
}

void Files::open_beside(Document document, Origin origin) {
  session_.add(std::move(document), origin, settings_.per_inch);
}

void Files::open() {
  dialogs_.ask_path(FileAsk::kOpen, tr("Open a draft"), document().path(),
                    [this](const std::string& path) { open_path(path); });
}

void Files::open_path(const std::string& path) {
  if (const OpenDocument* there = session_.on_file(path)) {
    session_.show(there->id);
    return look_at_file();
  }
  remove_stale_files(path);
  OpenResult result = open_document(path);
  if (!result.document) return messages_.report(std::move(result.remarks), path);
  remember(settings_, path);
  open_beside(std::move(*result.document), Origin::kOwn);
}

void Files::open_copy(const std::string& path) {
  OpenResult result = open_document(path);
  if (!result.document) return messages_.report(std::move(result.remarks), path);
  open_beside(Document(result.document->now()), Origin::kShipped);
}

void Files::duplicate() {
  const fs::path name = document().name();
  Document copy(document().now());
  copy.without_file(name.stem().string() + "-copy.wif");
  open_beside(std::move(copy), Origin::kOwn);
}

void Files::save_shown(std::function<void()> then) {
  if (!document().path().empty()) return save_own(std::move(then));
  dialogs_.ask_path(FileAsk::kSave, tr("Save the draft as"), first_path(document()),
                    [this, then](const std::string& path) {
                      if (same_file(path, document().path())) save_own(then);
                      else save_to(path, then);
                    });
}

void Files::save_as() {
  dialogs_.ask_path(FileAsk::kSave, tr("Save the draft as"), first_path(document()), [this](const std::string& path) {
    if (same_file(path, document().path())) save_own(nullptr);
    else save_to(path, nullptr);
  });
}

void Files::save_each(std::vector<uint64_t> ids, const std::function<void()>& then) {
  if (ids.empty()) {
    if (then) then();
    return;
  }
  session_.show(ids.front());
  ids.erase(ids.begin());
  save_shown([this, ids, then] { save_each(ids, then); });
}

void Files::save_for_others() {
  fs::path start = document().path().empty() ? "untitled.wif" : document().path();
  start.replace_filename(start.stem().string() + "-plain.wif");
  dialogs_.ask_path(
      FileAsk::kSave, tr("Save for other programs and looms"), start.string(), [this](const std::string& path) {
        const std::string problem = write_file_atomically(path, write_plain_wif(document().now()));
        messages_.say(problem.empty() ? fill(tr("Wrote {file}"), arg("file", fs::path(path).filename().string()))
                                      : problem);
      });
}

void Files::save_to(const std::string& path, const std::function<void()>& then) {
  const OpenDocument* there = session_.on_file(path);
  const bool taken = there != nullptr && there->id != session_.active().id;
  const std::string problem =
      taken ? fill(tr("{path} is open in another tab."), arg("path", path)) : session_.save(session_.active().id, path);
  if (!problem.empty()) {
    return dialogs_.ask(
        Question{tr("The draft was not saved"),
                 fill(tr("{problem}\n\nYour work is still here. Choose another place."), arg("problem", problem)),
                 {mark("Save as\xE2\x80\xA6"), mark("Cancel")}},
        [this](int button) {
          if (button == 0) save_as();
        });
  }
  live_export_.keep(document());
  remember(settings_, path);
  messages_.say(fill(tr("Saved {file}"), arg("file", document().name())));
  if (then) then();
}

void Files::save_own(std::function<void()> then) {
  if (session_.active().document.look_at_file() != FileChange::kContent) return save_to(document().path(), then);
  ask_about_change(true, std::move(then));
}

void Files::look_at_file() {
  if (dialogs_.any() || dialogs_.system_asks()) return;
  switch (session_.active().document.look_at_file()) {
    case FileChange::kNone:
      return;
    case FileChange::kContent:
      return ask_about_change(false, nullptr);
    case FileChange::kGone:
      keep_mine();
      messages_.say(
          fill(tr("{file} has been moved or deleted. Saving writes it again."), arg("file", document().name())));
      return;
  }
}

void Files::keep_mine() {
  OpenDocument& open = session_.active();
  open.document.accept_file();
  open.document.mark_unsaved();
  session_.keep_unsaved(open);
  edited_();
}

void Files::ask_about_change(bool saving, std::function<void()> then) {
  const std::string text =
      document().is_saved() ? fill(tr("{path} is not what was opened or saved here."), arg("path", document().path()))
                            : fill(tr("{path} is not what was opened or saved here.\n\nReloading it loses your changes "
                                      "since the last save."),
                                   arg("path", document().path()));
  dialogs_.ask(Question{fill(tr("{file} was changed by another program"), arg("file", document().name())),
                        text,
                        {mark("Save a copy\xE2\x80\xA6"), mark("Keep mine"), mark("Reload"), mark("Cancel")}},
               [this, saving, then = std::move(then)](int button) {
                 const std::string path = document().path();
                 if (button == 0)
                   dialogs_.ask_path(FileAsk::kSave, tr("Save your draft as a copy"), free_name_beside(path),
                                     [this, then](const std::string& beside) { save_to(beside, then); });
                 if (button == 1 && saving) save_to(path, then);
                 if (button == 1 && !saving) keep_mine();
                 if (button == 2) read_again();
               });
}

void Files::read_again() {
  const std::string path = document().path();
  OpenResult result = open_document(path);
  if (!result.document) return messages_.report(std::move(result.remarks), path);
  session_.replace(session_.active().id, std::move(*result.document), settings_.per_inch);
  messages_.say(fill(tr("Reloaded {file}"), arg("file", document().name())));
}

void Files::reload() {
  if (document().path().empty()) return;
  if (document().is_saved()) return read_again();
  dialogs_.ask(Question{fill(tr("Reload {file}?"), arg("file", document().name())),
                        tr("Your changes since the last save would be lost."),
                        {mark("Reload"), mark("Cancel")}},
               [this](int button) {
                 if (button == 0) read_again();
               });
}

void Files::show_in_folder() {
  const std::string folder = fs::absolute(document().path()).parent_path().string();
  if (const std::string problem = open_folder(folder); !problem.empty()) messages_.say(problem);
}

}  // namespace weftlight::app
