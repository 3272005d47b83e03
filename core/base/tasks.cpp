#include "base/tasks.h"

#include <algorithm>
#include <cmath>

#include "base/caught.h"

namespace weftlight::base {
namespace {

constexpr float kStep = 0.01f;  // progress that is worth waking the window for

}  // namespace

TaskRunner::TaskRunner(std::function<void()> wake) : wake_(std::move(wake)), thread_([this] { work(); }) {}

TaskRunner::~TaskRunner() {
  stop();
  {
    const std::lock_guard lock(mutex_);
    closing_ = true;
  }
  changed_.notify_all();
  thread_.join();
}

void TaskRunner::start(Task task) {
  auto entry = std::make_shared<Entry>();
  entry->shown = {task.name, {}, task.kind, 0, !task.finishes, std::chrono::steady_clock::now()};
  entry->task = std::move(task);
  {
    const std::lock_guard lock(mutex_);
    const auto same = [&](const auto& other) { return other->shown.kind == entry->shown.kind; };
    if (running_ && same(running_) && !running_->task.finishes) running_->stop.request_stop();
    if (const auto at = std::ranges::find_if(waiting_, same); at != waiting_.end()) *at = std::move(entry);
    else waiting_.push_back(std::move(entry));
  }
  changed_.notify_all();
}

template <class Chosen>
void TaskRunner::stop_if(Chosen chosen) {
  {
    const std::lock_guard lock(mutex_);
    const auto stops = [&](const auto& entry) { return !entry->task.finishes && chosen(*entry); };
    if (running_ && stops(running_)) running_->stop.request_stop();
    for (const auto& entry : waiting_)
      if (stops(entry)) entry->stop.request_stop();
    std::erase_if(waiting_, stops);
  }
  changed_.notify_all();
}

void TaskRunner::stop(const std::string& kind) {
  stop_if([&](const Entry& entry) { return entry.shown.kind == kind; });
}

void TaskRunner::stop() {
  stop_if([](const Entry&) { return true; });
}

bool TaskRunner::take() {
  size_t count = 0;
  {
    const std::lock_guard lock(mutex_);
    count = results_.size();
  }
  // One by one, so that what a result throws loses no other.
  for (size_t i = 0; i < count; ++i) {
    std::unique_lock lock(mutex_);
    const Result result = std::move(results_.front());
    results_.pop_front();
    lock.unlock();
    if (!result.stop.stop_requested()) result.run();
  }
  return count > 0;
}

bool TaskRunner::is_wanted(const Entry& entry) { return !entry.stop.stop_requested(); }

bool TaskRunner::busy() const {
  const std::lock_guard lock(mutex_);
  return !waiting_.empty() || (running_ && is_wanted(*running_));
}

bool TaskRunner::busy(const std::string& kind) const {
  const std::lock_guard lock(mutex_);
  const auto of_kind = [&](const auto& entry) { return entry->shown.kind == kind && is_wanted(*entry); };
  return (running_ && of_kind(running_)) || std::ranges::any_of(waiting_, of_kind);
}

std::vector<ShownTask> TaskRunner::shown() const {
  const std::lock_guard lock(mutex_);
  std::vector<ShownTask> all;
  const auto show = [&](const auto& entry) {
    if (!entry->shown.name.empty() && is_wanted(*entry)) all.push_back(entry->shown);
  };
  if (running_) show(running_);
  for (const auto& entry : waiting_) show(entry);
  return all;
}

void TaskRunner::wait() const {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [this] { return idle(); });
}

bool TaskRunner::wait_for(std::chrono::milliseconds longest) const {
  std::unique_lock lock(mutex_);
  return changed_.wait_for(lock, longest, [this] { return idle(); });
}

void TaskRunner::report(Entry& entry, float share, const std::string& sentence) {
  {
    const std::lock_guard lock(mutex_);
    ShownTask& shown = entry.shown;
    const bool other = !sentence.empty() && sentence != shown.sentence;
    if (!other && std::abs(share - shown.share) < kStep) return;
    shown.share = std::clamp(share, 0.0f, 1.0f);
    if (other) shown.sentence = sentence;
  }
  if (wake_) wake_();
}

void TaskRunner::deliver(const Entry& entry, std::function<void()> result) {
  {
    const std::lock_guard lock(mutex_);
    if (entry.stop.stop_requested()) return;
    results_.push_back({entry.stop.get_token(), std::move(result)});
  }
  if (wake_) wake_();
}

/// What the task holds goes before anyone is told that it is done.
void TaskRunner::run(Entry& entry) noexcept {
  try {
    Task task = std::move(entry.task);
    const RunningTask running(
        entry.stop.get_token(),
        [this, &entry](float share, const std::string& sentence) { report(entry, share, sentence); },
        [this, &entry](std::function<void()> result) { deliver(entry, std::move(result)); });
    try {
      task.work(running);
    } catch (...) {
      const Failure why = thrown(ErrorKind::kInput);
      task.work = nullptr;  // perhaps there is memory then to say so
      if (task.failed && !running.stopped()) task.failed(why.value(), running);
    }
  } catch (...) {  // nobody is left to be told
  }
}

void TaskRunner::work() {
  std::unique_lock lock(mutex_);
  for (;;) {
    changed_.wait(lock, [this] { return closing_ || !waiting_.empty(); });
    if (waiting_.empty()) return;
    running_ = std::move(waiting_.front());
    waiting_.pop_front();
    const std::shared_ptr<Entry> entry = running_;
    lock.unlock();
    run(*entry);
    lock.lock();
    running_ = nullptr;
    changed_.notify_all();
  }
}

}  // namespace weftlight::base
