#include "app/dialogs.h"

#include <algorithm>
#include <filesystem>
#include <utility>

#include "app/file_filters.h"
#include "base/text.h"
#include "session/files/file_names.h"

namespace weftlight::app {

using base::arg, base::fill, base::mark, base::tr;
using session::DocumentView, session::with_file_ending;
using views::ClosestWeavePrompt, views::DialogOutcome, views::DialogResult, views::PathPrompt, views::draw_dialog;

namespace {

std::string file_name(const std::string& path) { return std::filesystem::path(path).filename().string(); }

}  // namespace

void Dialogs::ask(Dialog dialog, std::function<void(int)> then) {
  dialog_ = std::move(dialog);
  answer_ = std::move(then);
}

void Dialogs::when_none(std::function<void()> then) {
  if (any()) later_.push_back(std::move(then));
  else then();
}

bool Dialogs::run_next() {
  if (any() || later_.empty()) return false;
  const auto due = std::move(later_.front());
  later_.pop_front();
  due();
  return true;
}

void Dialogs::ask_path(FileAsk what, const std::string& title, const std::string& start,
                       std::function<void(const std::string&)> chosen, const std::string& ending) {
  // The system dialog is not modal: the answer belongs to the draft that was active when it opened.
  if (what != FileAsk::kOpen)
    chosen = [this, about = session_.active().id, then = std::move(chosen)](const std::string& path) {
      if (session_.find(about) == nullptr) return messages_.refuse(tr("Not saved: the draft has been closed"));
      session_.show(about);
      then(path);
    };
  if (!platform::FileDialog::is_there()) return ask_path_in_window(what, title, start, std::move(chosen), ending);
  if (what == FileAsk::kSave)
    chosen = [this, ending, then = std::move(chosen)](const std::string& path) { with_ending(path, ending, then); };
  file_dialog_.ask({what, title, start, file_filters(what, ending)}, std::move(chosen));
}

void Dialogs::ask_path_in_window(FileAsk what, const std::string& title, const std::string& start,
                                 std::function<void(const std::string&)> chosen, const std::string& ending) {
  constexpr const char* kButtons[] = {mark("Open"), mark("Save"), mark("Choose")};
  ask(PathPrompt{title, start, kButtons[static_cast<int>(what)]},
      [this, what, ending, chosen = std::move(chosen)](int) {
        const std::string typed = prompt<PathPrompt>().path;
        const std::string path = what == FileAsk::kSave ? with_file_ending(typed, ending) : typed;
        close();
        if (path.empty()) return;
        if (what != FileAsk::kSave) return chosen(path);
        before_replacing(
            {path},
            [](const std::string& there) {
              return Question{fill(tr("Replace {file}?"), arg("file", file_name(there))),
                              fill(tr("{path} already exists. Its contents would be lost."), arg("path", there)),
                              {mark("Replace"), mark("Cancel")},
                              1};
            },
            [chosen, path] { chosen(path); });
      });
}

void Dialogs::before_replacing(std::vector<std::string> files,
                               std::function<Question(const std::string& there)> question, std::function<void()> then) {
  const std::string first = files.front();
  base::Task task = base::task_with_result(
      [files = std::move(files)](const base::RunningTask&) {
        std::error_code ignored;
        const auto there =
            std::ranges::find_if(files, [&](const std::string& f) { return std::filesystem::exists(f, ignored); });
        return there != files.end() ? *there : std::string();
      },
      [this, question = std::move(question), then = std::move(then)](const base::Result<std::string>& there) {
        if (!there || there->empty()) return then();
        ask(question(*there), [then](int button) {
          if (button == 0) then();
        });
      });
  task.kind = "replace:" + first;
  task.name = fill(tr("Saving {file}"), arg("file", file_name(first)));
  task.may_be_left = true;
  tasks_.reading().start(std::move(task));
}

/// Appends the file ending, such as .wif or .pdf. If that makes another name, which exists, it asks again: the file
/// dialog confirmed only the typed name.
void Dialogs::with_ending(const std::string& typed, const std::string& ending,
                          const std::function<void(const std::string&)>& then) {
  const std::string path = with_file_ending(typed, ending);
  if (path == typed) return then(path);
  before_replacing(
      {path},
      [](const std::string& there) {
        return Question{fill(tr("Replace {file}?"), arg("file", file_name(there))),
                        tr("A file of that name already exists. Saving would replace it."),
                        {mark("Replace"), mark("Cancel")},
                        1};
      },
      [then, path] { then(path); });
}

void Dialogs::draw(PanelContext& c) {
  DialogResult result = draw_dialog(c, dialog_);
  c.wanted.add(std::move(result.edit));
  if (result.outcome == DialogOutcome::kOpen) return;
  if (shows<ClosestWeavePrompt>()) c.wanted.change_view([](DocumentView& v) { v.differences.closest.reset(); });
  schedule_.draw_after_event();
  const auto then = std::exchange(answer_, nullptr);
  if (result.outcome == DialogOutcome::kDone && then) then(result.button);
  // The callback may have opened the next dialog.
  if (!answer_) close();
}

}  // namespace weftlight::app
