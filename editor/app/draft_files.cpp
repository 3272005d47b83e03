#include "app/draft_files.h"

#include <chrono>
#include <filesystem>
#include <utility>

#include "base/text.h"
#include "platform/desktop.h"
#include "session/files/stale_files.h"
#include "session/tab_names.h"
#include "weaves/table.h"

namespace weftlight::app {

using base::arg, base::fill, base::mark, base::presets_dir, base::tr, base::write_file_atomically;
using session::FileChange, session::OpenDocument, session::changed_since, session::identify, session::open_document,
    session::remember, session::remove_stale_files, session::tab_name;
using views::Question;
using weaves::find_weave;
using wif::Severity, wif::write_plain_wif;

namespace {

namespace fs = std::filesystem;

/// The kind of the task that reads a file.
std::string reading_kind(const std::string& path) { return "read:" + path; }

std::string file_name(const std::string& path) { return fs::path(path).filename().string(); }

/// The path that a save dialog starts with.
std::string first_path(const Document& document) {
  if (!document.path().empty()) return document.path();
  return document.is_named() ? document.name() : document.file_stem() + ".wif";
}

/// "twill-2.wif"; where that exists, the dialog asks.
std::string name_of_copy(const std::string& path) {
  const fs::path file(path);
  return (file.parent_path() / (file.stem().string() + "-2" + file.extension().string())).string();
}

}  // namespace

Files::Files(Session& session, Settings& settings, BackgroundTasks& tasks, Dialogs& dialogs, Messages& messages,
             LiveExportWriter& live_export, std::function<void()> edited)
    : session_(session),
      settings_(settings),
      tasks_(tasks),
      dialogs_(dialogs),
      messages_(messages),
      live_export_(live_export),
      edited_(std::move(edited)),
      saver_(session, tasks.writing()) {}

Document Files::first_document() {
  OpenResult starter = open_document(presets_dir() + "/drafts/starter.wif");
  if (!starter.document) return Document(weaves::new_draft(*find_weave("straight"), {}, {48, 48}).design);
  // Unnamed, so that saving asks where.
  Document& d = *starter.document;
  return Document(d.now());
}

void Files::open_beside(Document document, Origin origin) { session_.add(std::move(document), origin); }

void Files::open_new(design::Design design) {
  Document document(with_usual_plan(std::move(design), settings_));
  document.mark_unsaved();  // what was typed for it is work
  open_beside(std::move(document), Origin::kOwn);
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
  read(path, [this, path](OpenResult result) {
    if (!result.document) return messages_.report(std::move(result.remarks), path);
    if (const OpenDocument* there = session_.on_file(path, result.document->file())) return session_.show(there->id);
    remember(settings_, path);
    open_beside(std::move(*result.document), Origin::kOwn);
  });
}

void Files::open_copy(const std::string& path) {
  read(path, [this, path](OpenResult result) {
    if (!result.document) return messages_.report(std::move(result.remarks), path);
    open_beside(Document(result.document->now()), Origin::kShipped);
  });
}

void Files::read(const std::string& path, std::function<void(OpenResult)> then) {
  base::Task task = base::task_with_result(
      [path](const base::RunningTask& running) {
        remove_stale_files(path);
        return open_document(path, running.stop());
      },
      [this, path, then = std::move(then)](base::Result<OpenResult> result) {
        if (result) then(std::move(*result));
        else messages_.report({{Severity::kError, 0, message(result.error()), {}}}, path);
        end_start(reading_kind(path));
      });
  task.kind = reading_kind(path);
  task.name = fill(tr("Opening {file}"), arg("file", file_name(path)));
  task.may_be_left = true;
  tasks_.reading().start(std::move(task));
}

void Files::start_with(const std::vector<std::string>& paths) {
  constexpr std::chrono::milliseconds kPatience{300};  // a window that shows another draft first would flicker
  for (const std::string& path : paths) starting_.insert(reading_kind(path));
  for (const std::string& path : paths) open_path(path);
  if (tasks_.reading().wait_for(kPatience)) tasks_.reading().take();
}

void Files::end_start(const std::string& kind) {
  if (starting_.erase(kind) > 0) keep_live_export();
}

void Files::cancel(const std::string& kind) {
  tasks_.reading().stop(kind);
  end_start(kind);
}

void Files::keep_live_export() {
  if (!starting()) live_export_.keep(document());
}

void Files::duplicate() {
  Document copy(document().now());
  copy.without_file(document().file_stem() + "-copy.wif");
  open_beside(std::move(copy), Origin::kOwn);
}

void Files::save_shown(const std::function<void()>& then) {
  if (!document().path().empty()) return save_to(document().path(), false, then);
  dialogs_.ask_path(FileAsk::kSave, tr("Save the draft as"), first_path(document()),
                    [this, then](const std::string& path) { save_to(path, false, then); });
}

void Files::save_as() {
  dialogs_.ask_path(FileAsk::kSave, tr("Save the draft as"), first_path(document()),
                    [this](const std::string& path) { save_to(path, false, nullptr); });
}

void Files::save_each(std::vector<uint64_t> ids, const std::function<void()>& then) {
  // Closed or saved while others were written.
  std::erase_if(ids, [this](uint64_t id) {
    const OpenDocument* open = session_.find(id);
    return open == nullptr || open->document.is_saved();
  });
  if (ids.empty()) {
    if (then) then();
    return;
  }
  session_.show(ids.front());
  ids.erase(ids.begin());
  save_shown([this, ids, then] { save_each(ids, then); });
}

void Files::save_for_others() {
  const fs::path start = fs::path(document().path()).parent_path() / (document().file_stem() + "-plain.wif");
  dialogs_.ask_path(FileAsk::kSave, tr("Save for other programs and looms"), start.string(),
                    [this](const std::string& path) {
                      write(path, [design = document().snapshot()] { return write_plain_wif(*design); });
                    });
}

void Files::write(const std::string& path, std::function<std::string()> make) {
  base::Task task = base::task_with_result(
      [path, make = std::move(make)](const base::RunningTask&) { return write_file_atomically(path, make()); },
      [this, path](const base::Result<void>& written) {
        if (written) messages_.say(fill(tr("Wrote {file}"), arg("file", file_name(path))));
        else messages_.refuse(fill(tr("Not saved: {problem}"), arg("problem", message(written.error()))));
      });
  task.kind = "write:" + path;
  task.name = fill(tr("Writing {file}"), arg("file", file_name(path)));
  task.finishes = true;
  tasks_.writing().start(std::move(task));
}

void Files::save_to(const std::string& path, bool over_changes, const std::function<void()>& then) {
  const uint64_t id = session_.active().id;
  const OpenDocument* there = session_.on_file(path);
  if ((there != nullptr && there->id != id) || saver_.takes(path, id))
    return tell_not_saved(id, fill(tr("{path} is open in another tab."), arg("path", path)));
  saver_.save(id, path, over_changes,
              [this, id, path, then](const SaveResult& result) { saved(id, path, result, then); });
}

void Files::saved(uint64_t id, const std::string& path, const SaveResult& result, const std::function<void()>& then) {
  if (!result) return tell_not_saved(id, message(result.error()));
  if (result->changed)
    return dialogs_.when_none([this, id, then] {
      if (session_.find(id) == nullptr) return;
      session_.show(id);
      ask_about_change({}, then);
    });
  keep_live_export();
  remember(settings_, path);
  messages_.say(fill(tr("Saved {file}"), arg("file", file_name(path))));
  if (then) dialogs_.when_none(then);  // it may ask something
}

void Files::tell_not_saved(uint64_t id, const std::string& problem) {
  dialogs_.when_none([this, id, problem] {
    session_.show(id);
    dialogs_.ask(
        Question{tr("The draft was not saved"),
                 fill(tr("{problem}\n\nYour work is still here. Choose another location."), arg("problem", problem)),
                 {mark("Save as\xE2\x80\xA6"), mark("Cancel")}},
        [this](int button) {
          if (button == 0) save_as();
        });
  });
}

void Files::look_at_file() {
  if (dialogs_.any() || dialogs_.system_asks()) return;
  const OpenDocument& open = session_.active();
  if (open.document.path().empty() || saver_.saving(open.id)) return;
  const std::string kind = "look:" + open.document.path();
  if (tasks_.looking().busy(kind)) return;
  struct Seen {
    FileChange change;
    FileIdentity now;
  };
  base::Task task = base::task_with_result(
      [path = open.document.path(), known = open.document.file()](const base::RunningTask&) {
        FileIdentity now = known;
        const FileChange change = changed_since(path, now);
        if (change == FileChange::kContent) now = identify(path);
        return Seen{change, now};
      },
      [this, id = open.id, known = open.document.file()](const base::Result<Seen>& look) {
        if (!look) return;
        OpenDocument* asked = session_.find(id);
        // Saved or read again meanwhile, or no longer shown: the next look counts.
        if (asked == nullptr || &session_.active() != asked || saver_.saving(id) || asked->document.file() != known)
          return;
        asked->document.accept(look->change == FileChange::kNone ? look->now : known);
        if (look->change == FileChange::kGone) {
          keep_mine({});
          messages_.say(
              fill(tr("{file} has been moved or deleted. Saving writes it again."), arg("file", document().name())));
        }
        if (look->change == FileChange::kContent && !dialogs_.any()) ask_about_change(look->now, nullptr);
      });
  task.kind = kind;
  task.may_be_left = true;
  tasks_.looking().stop();  // one that hangs at another file
  tasks_.looking().start(std::move(task));
}

void Files::keep_mine(const FileIdentity& on_disk) {
  OpenDocument& open = session_.active();
  open.document.accept(on_disk);
  open.document.mark_unsaved();
  session_.keep_unsaved(open);
  edited_();
}

void Files::ask_about_change(const std::optional<FileIdentity>& on_disk, std::function<void()> then) {
  const std::string text =
      document().is_saved()
          ? fill(tr("{path} has changed since it was opened or saved here."), arg("path", document().path()))
          : fill(tr("{path} has changed since it was opened or saved here.\n\nReloading it loses your changes since "
                    "the last save."),
                 arg("path", document().path()));
  dialogs_.ask(
      Question{fill(tr("{file} was changed by another program"), arg("file", tab_name(session_, session_.active().id))),
               text,
               {mark("Save a copy\xE2\x80\xA6"), mark("Keep mine"), mark("Reload"), mark("Cancel")}},
      [this, on_disk, then = std::move(then)](int button) {
        const std::string path = document().path();
        if (button == 0)
          dialogs_.ask_path(FileAsk::kSave, tr("Save your draft as a copy"), name_of_copy(path),
                            [this, then](const std::string& beside) { save_to(beside, false, then); });
        if (button == 1 && on_disk) keep_mine(*on_disk);
        if (button == 1 && !on_disk) save_to(path, true, then);
        if (button == 2) read_again();
      });
}

void Files::read_again() {
  const OpenDocument& open = session_.active();
  const std::string path = open.document.path();
  read(path, [this, path, id = open.id, before = open.document.snapshot()](OpenResult result) {
    if (!result.document) return messages_.report(std::move(result.remarks), path);
    const OpenDocument* asked = session_.find(id);
    if (asked == nullptr) return;
    const std::string name = asked->document.name();
    if (asked->document.snapshot() != before)
      return messages_.say(
          fill(tr("{file} was not reloaded, because you have edited it meanwhile"), arg("file", name)));
    session_.replace(id, std::move(*result.document));
    messages_.say(fill(tr("Reloaded {file}"), arg("file", name)));
  });
}

void Files::reload() {
  if (document().path().empty()) return;
  if (document().is_saved()) return read_again();
  dialogs_.ask(Question{fill(tr("Reload {file}?"), arg("file", tab_name(session_, session_.active().id))),
                        tr("Your changes since the last save would be lost."),
                        {mark("Reload"), mark("Cancel")},
                        1},
               [this](int button) {
                 if (button == 0) read_again();
               });
}

void Files::show_in_folder() {
  const std::string folder = fs::absolute(document().path()).parent_path().string();
  if (const auto shown = platform::show_folder(folder); !shown)
    messages_.say(fill(tr("No file manager was found ({program} is missing). The folder is {folder}"),
                       arg("program", shown.error().program), arg("folder", folder)));
}

}  // namespace weftlight::app
