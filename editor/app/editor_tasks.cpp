// What the editor has done beside the window: reading and writing files, long searches. The results are taken up here.

#include <algorithm>
#include <filesystem>
#include <utility>

#include "app/editor.h"
#include "base/text.h"
#include "session/files/stale_files.h"
#include "views/shell/task_line.h"

namespace weftlight::app {

using base::arg;
using base::fill;
using base::mark;
using base::tr;

namespace {

using Clock = std::chrono::steady_clock;
constexpr std::chrono::milliseconds kShownAfter{300};  // shorter tasks would only flicker

std::string name_of(const std::string& path) { return std::filesystem::path(path).filename().string(); }

}  // namespace

bool Editor::take_results() {
  bool any = writing_.take();
  // These may change the draft or show another one: not in the middle of a gesture or a dialog.
  if (!ImGui::IsAnyMouseDown() && no_dialog()) any |= reading_.take() | computing_.take();
  if (SlowEdits::News news = slow_edits_.take_news(); any) {
    if (news.edited) edited();
    if (!news.said.empty()) say(std::move(news.said));
  }
  if (!later_.empty() && no_dialog()) {
    const auto due = std::move(later_.front());
    later_.pop_front();
    due();
    any = true;
  }
  return any;
}

void Editor::when_no_dialog(std::function<void()> then) {
  if (no_dialog()) then();
  else later_.push_back(std::move(then));
}

bool Editor::update_shown_task() {
  std::optional<base::ShownTask> now;
  const auto begun = Clock::now() - kShownAfter;
  for (const base::TaskRunner* runner : {&writing_, &computing_, &reading_})
    for (base::ShownTask& task : runner->shown())
      if (!now && task.since < begun) now = std::move(task);
  const bool same = now.has_value() == shown_task_.has_value() &&
                    (!now || (now->name == shown_task_->name && now->sentence == shown_task_->sentence &&
                              now->share == shown_task_->share));
  shown_task_ = std::move(now);
  return !same;
}

void Editor::draw_task(PanelContext& c) {
  if (!shown_task_) return;
  const char* awaits = saver_.awaited(0) ? tr("Weftlight closes when your drafts are saved\xE2\x80\xA6")
                       : saver_.awaited(session_.active().id)
                           ? tr("This tab closes when its draft is saved\xE2\x80\xA6")
                           : "";
  if (draw_task_line(c, *shown_task_, awaits)) cancel(*shown_task_);
}

void Editor::cancel(const base::ShownTask& task) {
  reading_.stop(task.kind);
  slow_edits_.cancel(task.kind);
  end_start();
  say(fill(tr("Cancelled: {task}"), arg("task", task.name)));
}

void Editor::read(const std::string& path, std::function<void(OpenResult)> then) {
  base::Task task = base::task_with_result(
      [path](const base::RunningTask&) {
        remove_stale_files(path);
        return open_document(path);
      },
      [this, then = std::move(then)](OpenResult result) {
        then(std::move(result));
        end_start();
      },
      [this, path](const std::string& why) {
        report({{Severity::kError, 0, why, {}}}, path);
        end_start();
      });
  task.kind = "read:" + path;
  task.name = fill(tr("Opening {file}"), arg("file", name_of(path)));
  reading_.start(std::move(task));
}

void Editor::start_with(const std::string& path) {
  constexpr std::chrono::milliseconds kPatience{300};  // a window that shows another draft first would flicker
  starting_ = true;
  open_path(path);
  if (reading_.wait_for(kPatience)) reading_.take();
}

void Editor::end_start() {
  if (!std::exchange(starting_, false)) return;
  follow_shown();
  keep_live_export();
}

void Editor::look_for_left_work(bool gallery) {
  base::Task task =
      base::task_with_result([this](const base::RunningTask&) { return session_.find_left(); },
                             [this, gallery](std::vector<LeftWork> left) {
                               session_.set_left(std::move(left));
                               if (!session_.left().empty()) when_no_dialog([this] { offer_recovery(); });
                               else if (gallery && no_dialog()) show_gallery(settings_.recent.empty());
                             },
                             [this](const std::string& why) {
                               say(fill(tr("Unsaved work cannot be looked for: {problem}"), arg("problem", why)));
                             });
  task.kind = "left";
  computing_.start(std::move(task));
}

void Editor::write(const std::string& path, std::function<std::string()> make) {
  base::Task task = base::task_with_result(
      [path, make = std::move(make)](const base::RunningTask&) { return write_file_atomically(path, make()); },
      [this, path](const std::string& problem) {
        say(problem.empty() ? fill(tr("Wrote {file}"), arg("file", name_of(path))) : problem);
      },
      [this, path](const std::string& why) {
        say(fill(tr("{file} was not written: {problem}"), arg("file", name_of(path)), arg("problem", why)));
      });
  task.kind = "write:" + path;
  task.name = fill(tr("Writing {file}"), arg("file", name_of(path)));
  task.finishes = true;
  writing_.start(std::move(task));
}

}  // namespace weftlight::app
