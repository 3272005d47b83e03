#include "app/background_tasks.h"

#include <chrono>

#include "views/shell/task_line.h"

namespace weftlight::app {

using views::draw_task_line;

namespace {

using Clock = std::chrono::steady_clock;
constexpr std::chrono::milliseconds kShownAfter{300};  // shorter tasks would only flicker

}  // namespace

bool BackgroundTasks::take(bool may_change_draft) {
  bool any = writing_.take();
  if (may_change_draft) any |= reading_.take() | looking_.take() | computing_.take();
  return any;
}

bool BackgroundTasks::update_shown() {
  std::optional<base::ShownTask> now;
  const auto begun = Clock::now() - kShownAfter;
  for (const base::TaskRunner* runner : {&writing_, &computing_, &reading_})
    for (base::ShownTask& task : runner->shown())
      if (!now && task.since < begun) now = std::move(task);
  const bool same =
      now.has_value() == shown_.has_value() &&
      (!now || (now->name == shown_->name && now->sentence == shown_->sentence && now->share == shown_->share));
  shown_ = std::move(now);
  return !same;
}

void BackgroundTasks::draw(PanelContext& c, const std::string& awaits) {
  if (shown_ && draw_task_line(c, *shown_, awaits)) cancelled_ = shown_;
}

}  // namespace weftlight::app
