#include "app/editor.h"

#include <algorithm>
#include <filesystem>
#include <utility>

#include "base/text.h"
#include "base/user_folders.h"
#include "draft/edits.h"
#include "files/files.h"
#include "session/file_names.h"
#include "session/gallery.h"
#include "session/stale_files.h"

namespace weftlight::app {

using base::arg;
using base::fill;
using base::mark;
using base::tr;
using base::tr_n;

namespace {

/// The path that a save dialog starts with.
std::string first_path(const Document& document) {
  if (!document.path().empty()) return document.path();
  return document.name() == "Untitled" ? "untitled.wif" : document.name();
}

std::string joined(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  return text;
}

std::vector<std::string> split_lines(const std::string& text) {
  std::vector<std::string> lines;
  for (size_t at = 0; at < text.size();) {
    const size_t end = std::min(text.find('\n', at), text.size());
    lines.push_back(text.substr(at, end - at));
    at = end + 1;
  }
  return lines;
}

}  // namespace

Document Editor::first_document() {
  OpenResult starter = open_document(presets_dir() + "/drafts/starter.wif");
  if (!starter.document) return Document(draft::new_draft(*find_weave("straight"), {}, {48, 48}).design);
  // Unnamed, so that saving asks where.
  Document& d = *starter.document;
  return Document(d.now());
}

Editor::Editor(Window& window, const EditorOptions& options)
    : window_(window),
      options_(options),
      settings_(load_settings()),
      session_(state_folder() + "/recovery", first_document(), settings_.per_inch),
      live_export_(std::make_shared<LiveExport>(options.live_export, state_folder())),
      preview_(Window::wake),
      map_file_(options.ui_map) {
  style_.dark = settings_.dark;
  remake_actions();
  if (!options.file.empty()) open_path(options.file);
  // No tour if a program drives the window.
  if (!settings_.toured && options.ui_map.empty() && options.live_export.empty()) settings_.tour = 0;
  follow_shown();
  offer_recovery();
  const bool driven = !options.ui_map.empty() || !options.live_export.empty();
  if (std::holds_alternative<std::monostate>(dialog_) && opens_with_gallery(settings_, !options.file.empty(), driven))
    show_gallery(settings_.recent.empty());
}

void Editor::open() {
  ask_path(FileAsk::kOpen, tr("Open a draft"), document().path(), [this](const std::string& path) { open_path(path); });
}

void Editor::open_path(const std::string& path) {
  if (const OpenDocument* there = session_.on_file(path)) {
    session_.show(there->id);
    return look_at_file();
  }
  remove_stale_files(path);
  OpenResult result = open_document(path);
  if (!result.document) return report(std::move(result.remarks), path);
  remember(settings_, path);
  remake_actions();
  open_beside(std::move(*result.document), Origin::kOwn);
}

void Editor::open_copy(const std::string& path) {
  OpenResult result = open_document(path);
  if (!result.document) return report(std::move(result.remarks), path);
  open_beside(Document(result.document->now()), Origin::kShipped);
}

void Editor::save() { save_shown(nullptr); }

void Editor::save_shown(std::function<void()> then) {
  if (!document().path().empty()) return save_own(std::move(then));
  ask_path(FileAsk::kSave, tr("Save the draft as"), first_path(document()), [this, then](const std::string& path) {
    if (same_file(path, document().path())) save_own(then);
    else save_to(path, then);
  });
}

void Editor::save_as() {
  ask_path(FileAsk::kSave, tr("Save the draft as"), first_path(document()), [this](const std::string& path) {
    if (same_file(path, document().path())) save_own(nullptr);
    else save_to(path, nullptr);
  });
}

void Editor::save_all() { save_each(session_.unsaved(), nullptr); }

void Editor::save_each(std::vector<uint64_t> ids, const std::function<void()>& then) {
  if (ids.empty()) {
    if (then) then();
    return;
  }
  session_.show(ids.front());
  ids.erase(ids.begin());
  save_shown([this, ids, then] { save_each(ids, then); });
}

void Editor::save_for_others() {
  std::filesystem::path start = document().path().empty() ? "untitled.wif" : document().path();
  start.replace_filename(start.stem().string() + "-plain.wif");
  ask_path(FileAsk::kSave, tr("Save for other programs and looms"), start.string(), [this](const std::string& path) {
    const std::string problem = write_file_atomically(path, write_plain_wif(document().now()));
    say(problem.empty() ? fill(tr("Wrote {file}"), arg("file", std::filesystem::path(path).filename().string()))
                        : problem);
  });
}

void Editor::save_to(const std::string& path, const std::function<void()>& then) {
  const OpenDocument* there = session_.on_file(path);
  const bool taken = there != nullptr && there->id != session_.active().id;
  const std::string problem =
      taken ? fill(tr("{path} is open in another tab."), arg("path", path)) : session_.save(session_.active().id, path);
  if (!problem.empty()) {
    return ask(
        Question{tr("The draft was not saved"),
                 fill(tr("{problem}\n\nYour work is still here. Choose another place."), arg("problem", problem)),
                 {mark("Save as\xE2\x80\xA6"), mark("Cancel")}},
        [this](int button) {
          if (button == 0) save_as();
        });
  }
  keep_live_export();
  remember(settings_, path);
  remake_actions();
  say(fill(tr("Saved {file}"), arg("file", document().name())));
  if (then) then();
}

void Editor::quit() {
  const std::vector<uint64_t> unsaved = session_.unsaved();
  if (unsaved.empty()) {
    leaving_ = true;
    return;
  }
  if (unsaved.size() == 1) session_.show(unsaved.front());
  std::string names;
  for (const uint64_t id : unsaved) names += (names.empty() ? "" : ", ") + session_.find(id)->document.shown_name();
  const bool one = unsaved.size() == 1;
  const std::string question =
      one ? fill(tr("Save the changes to {draft}?"), arg("draft", names))
          : fill(tr_n("Save the changes to {count} draft?", "Save the changes to {count} drafts?",
                      static_cast<long long>(unsaved.size())),
                 arg("count", unsaved.size()));
  ask(Question{question,
               (one ? "" : names + "\n\n") + tr("Your changes since the last save would be lost."),
               {one ? mark("Save") : mark("Save all"), mark("Do not save"), mark("Cancel")}},
      [this, unsaved](int button) {
        if (button == 1) leaving_ = true;
        if (button == 0) save_each(unsaved, [this] { leaving_ = true; });
      });
}

void Editor::show_tab(int by) {
  session_.step(by);
  look_at_file();
}

void Editor::undo() {
  if (session_.undo()) edited();
}

void Editor::redo() {
  if (session_.redo()) edited();
}

void Editor::go_to_step(size_t step) {
  if (session_.go_to(step)) edited();
}

void Editor::commit(const Edit& edit) {
  if (session_.commit(edit, edit.stroke != 0 ? edit.stroke : strokes_.now())) return edited();
  if (!edit.why) return;
  if (std::string why = edit.why(document().now()); !why.empty()) say(std::move(why));
}

void Editor::ask_size() {
  const Draft& d = document().now().draft;
  const Loom& loom = document().now().loom;
  ask(SizePrompt{tr("Size of the draft"), mark("Change"), d.ends(), d.picks(), d.shafts, d.treadles, loom.shafts,
                 loom.treadles},
      [this](int) {
        const SizePrompt p = std::get<SizePrompt>(dialog_);
        commit({tr("Change size"), [p](Design d2) {
                  d2.loom.shafts = p.loom_shafts;
                  d2.loom.treadles = p.loom_treadles;
                  return with_size(std::move(d2), p.ends, p.picks, p.shafts, p.treadles);
                }});
        view().draft.pitch = 0;
      });
}

void Editor::ask_notes() {
  const Design& d = document().now();
  ask(NotesPrompt{d.title, d.author, joined(d.notes)}, [this](int) {
    const NotesPrompt p = std::get<NotesPrompt>(dialog_);
    commit({tr("Title and notes"), [p](Design d2) {
              d2.title = p.title;
              d2.author = p.author;
              d2.notes = split_lines(p.notes);
              return d2;
            }});
  });
}

void Editor::ask_thread() {
  const Draft& d = document().now().draft;
  ask(ThreadPrompt{view().chosen.system, 1, d.ends(), d.picks()}, [this](int) {
    const ThreadPrompt p = std::get<ThreadPrompt>(dialog_);
    const Draft& draft = document().now().draft;
    const int thread = std::clamp(p.number, 1, draft.threads(p.system).size()) - 1;
    scroll_to(view().draft, p.system, thread);
    view().chosen = {p.system, {thread}, thread, {}, false, false};
  });
}

void Editor::show_commands() {
  commands_ = {};
  commands_.open = commands_.appearing = true;
}

void Editor::toggle_theme() {
  style_.dark = settings_.dark = !style_.dark;
  restyle_ = true;
}

void Editor::remake_actions() {
  views_in_menu_.clear();
  for (const NamedView& v : document().now().views) views_in_menu_.push_back(v.name);
  actions_ = make_actions(settings_.recent, settings_.keys, views_in_menu_);
}

void Editor::open_beside(Document document, Origin origin) {
  session_.add(std::move(document), origin, settings_.per_inch);
}

void Editor::follow_shown() {
  if (shown_ == session_.active().id) return;
  shown_ = session_.active().id;
  remarks_ = session_.active().remarks;
  remarks_open_ = remarks_open_ && !remarks_.empty();
  analysis_ = {};
  typed_threads_.clear();
  edited();
}

/// Called after every change of the shown design.
void Editor::edited() {
  if (!std::ranges::equal(views_in_menu_, document().now().views, {}, {}, &NamedView::name)) remake_actions();
  preview_.submit(hung());
  draper_.follow(document().snapshot());
  keep_live_export();
  export_again();
  frames_due_ = std::max(frames_due_, 3);
}

void Editor::say(std::string text) {
  message_ = std::move(text);
  said_at_s_ = Window::seconds();
}

std::string Editor::clipboard() const {
  const char* text = ImGui::GetClipboardText();
  return text != nullptr ? text : "";
}

void Editor::set_clipboard(const std::string& text) { ImGui::SetClipboardText(text.c_str()); }

void Editor::report(std::vector<Diagnostic> remarks, const std::string& path) {
  remarks_ = std::move(remarks);
  remarks_open_ = true;
  say(fill(tr("{file} could not be opened"), arg("file", std::filesystem::path(path).filename().string())));
}

void Editor::ask(Dialog dialog, std::function<void(int)> then) {
  dialog_ = std::move(dialog);
  answer_ = std::move(then);
}

void Editor::ask_path(FileAsk what, const std::string& title, const std::string& start,
                      std::function<void(const std::string&)> chosen, const std::string& ending) {
  // The system dialog is not modal: the answer belongs to the draft that was active when it opened.
  if (what != FileAsk::kOpen)
    chosen = [this, about = session_.active().id, then = std::move(chosen)](const std::string& path) {
      if (session_.find(about) == nullptr) return say(tr("Not written: the draft has been closed"));
      session_.show(about);
      then(path);
    };
  if (FileDialog::is_there()) {
    if (what == FileAsk::kSave)
      chosen = [this, ending, then = std::move(chosen)](const std::string& path) { with_ending(path, ending, then); };
    return file_dialog_.ask(what, title, start, ending, std::move(chosen));
  }
  constexpr const char* kButtons[] = {mark("Open"), mark("Save"), mark("Export")};
  ask(PathPrompt{title, start, kButtons[static_cast<int>(what)]},
      [this, what, ending, chosen = std::move(chosen)](int) {
        const std::string typed = std::get<PathPrompt>(dialog_).path;
        const std::string path = what == FileAsk::kSave ? with_file_ending(typed, ending) : typed;
        dialog_ = {};
        if (path.empty()) return;
        std::error_code ignored;
        if (what != FileAsk::kSave || !std::filesystem::exists(path, ignored)) return chosen(path);
        ask(Question{fill(tr("Replace {file}?"), arg("file", std::filesystem::path(path).filename().string())),
                     fill(tr("{path} already exists. Its contents would be lost."), arg("path", path)),
                     {mark("Replace"), mark("Cancel")}},
            [chosen, path](int button) {
              if (button == 0) chosen(path);
            });
      });
}

/// Appends the file ending, such as .wif or .pdf. If that makes another name, which exists, it asks again: the file
/// dialog confirmed only the typed name.
void Editor::with_ending(const std::string& typed, const std::string& ending,
                         const std::function<void(const std::string&)>& then) {
  const std::string path = with_file_ending(typed, ending);
  std::error_code error;
  if (path == typed || !std::filesystem::exists(path, error)) return then(path);
  ask(Question{fill(tr("Replace {file}?"), arg("file", std::filesystem::path(path).filename().string())),
               tr("A file of that name already exists. Saving would replace it."),
               {mark("Replace"), mark("Cancel")}},
      [then, path](int button) {
        if (button == 0) then(path);
      });
}

void Editor::update_title() {
  const std::string title = std::string(document().is_saved() ? "" : "\xE2\x97\x8F ") + document().shown_name();
  if (title != title_) window_.set_title(title + " \xE2\x80\x93 Weftlight");
  title_ = title;
}

void Editor::run_action(const std::string& id) {
  for (const Action& a : actions_) {
    if (a.item.id != id || (a.enabled && !a.enabled(*this))) continue;
    const auto run = a.run;  // running may make the table again
    return run(*this);
  }
}

}  // namespace weftlight::app
