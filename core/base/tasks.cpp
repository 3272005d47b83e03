#include "base/tasks.h"

#include <algorithm>
#include <cmath>
#include <system_error>

#include "base/caught.h"

namespace weftlight::base {
namespace {

constexpr float kStep = 0.01f;                // progress that is worth waking the window for
constexpr std::chrono::seconds kPatience{1};  // at the end of a runner, with a task that may hang

}  // namespace

TaskRunner::TaskRunner(std::function<void()> wake)
    : state_(std::make_shared<State>(std::move(wake))), thread_(begin(state_->thread)) {}

/// The caller holds the lock, but in the constructor.
std::thread TaskRunner::begin(int number) const {
  std::thread thread([state = state_, number] { work(state, number); });
  ++state_->alive;
  return thread;
}

TaskRunner::~TaskRunner() {
  {
    std::unique_lock lock(state_->mutex);
    state_->closing = true;
    request_stop([](const Entry&) { return true; });
    state_->changed.notify_all();
    state_->changed.wait_for(lock, kPatience, [this] { return state_->alive == 0; });
    if (state_->running && state_->running->task.may_be_left) leave_running();
  }
  if (thread_.joinable()) thread_.join();
  // Results hold what belongs to their taker, and wake() may not be there any more. One by one, without the lock and
  // without another list, which would take memory.
  std::unique_lock lock(state_->mutex);
  state_->changed.wait(lock, [this] { return state_->waking == 0; });
  while (!state_->results.empty()) {
    Result dropped = std::move(state_->results.front());
    state_->results.pop_front();
    lock.unlock();
    dropped = {};
    lock.lock();
  }
}

void TaskRunner::start(Task task) {
  auto entry = std::make_shared<Entry>();
  entry->shown = {task.name, {}, task.kind, 0, !task.finishes, std::chrono::steady_clock::now()};
  entry->task = std::move(task);
  {
    const std::lock_guard lock(state_->mutex);
    Entries& waiting = state_->waiting;
    const std::shared_ptr<Entry>& running = state_->running;
    const auto same = [&](const auto& other) { return other->shown.kind == entry->shown.kind; };
    if (running && same(running) && !running->task.finishes) running->stop.request_stop();
    if (const auto at = std::ranges::find_if(waiting, same); at != waiting.end()) *at = std::move(entry);
    else waiting.push_back(std::move(entry));
  }
  state_->changed.notify_all();
}

/// Drops waiting tasks and asks the running one to stop; true if it was asked. The caller holds the lock.
template <class Chosen>
bool TaskRunner::request_stop(Chosen chosen) {
  const auto stops = [&](const auto& entry) { return !entry->task.finishes && chosen(*entry); };
  for (const auto& entry : state_->waiting)
    if (stops(entry)) entry->stop.request_stop();
  std::erase_if(state_->waiting, stops);
  if (!state_->running || !stops(state_->running)) return false;
  state_->running->stop.request_stop();
  return true;
}

template <class Chosen>
void TaskRunner::stop_if(Chosen chosen) {
  {
    const std::lock_guard lock(state_->mutex);
    if (request_stop(chosen) && state_->running->task.may_be_left) leave_running();
  }
  state_->changed.notify_all();
}

/// Goes on with another thread, unless there is nothing more to do or none to be had. The caller holds the lock.
void TaskRunner::leave_running() {
  std::thread next;
  try {
    if (!state_->closing || !state_->waiting.empty()) next = begin(state_->thread + 1);
  } catch (const std::system_error&) {
    return;
  }
  ++state_->thread;
  state_->running = nullptr;
  thread_.detach();
  thread_ = std::move(next);
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
    const std::lock_guard lock(state_->mutex);
    count = state_->results.size();
  }
  // One by one, so that what a result throws loses no other.
  for (size_t i = 0; i < count; ++i) {
    std::unique_lock lock(state_->mutex);
    const Result result = std::move(state_->results.front());
    state_->results.pop_front();
    lock.unlock();
    if (!result.stop.stop_requested()) result.run();
  }
  return count > 0;
}

bool TaskRunner::is_wanted(const Entry& entry) { return !entry.stop.stop_requested(); }

bool TaskRunner::busy() const {
  const std::lock_guard lock(state_->mutex);
  return !state_->waiting.empty() || (state_->running && is_wanted(*state_->running));
}

bool TaskRunner::busy(const std::string& kind) const {
  const std::lock_guard lock(state_->mutex);
  const auto of_kind = [&](const auto& entry) { return entry->shown.kind == kind && is_wanted(*entry); };
  return (state_->running && of_kind(state_->running)) || std::ranges::any_of(state_->waiting, of_kind);
}

std::vector<ShownTask> TaskRunner::shown() const {
  const std::lock_guard lock(state_->mutex);
  std::vector<ShownTask> all;
  const auto show = [&](const auto& entry) {
    if (!entry->shown.name.empty() && is_wanted(*entry)) all.push_back(entry->shown);
  };
  if (state_->running) show(state_->running);
  for (const auto& entry : state_->waiting) show(entry);
  return all;
}

void TaskRunner::wait() const {
  std::unique_lock lock(state_->mutex);
  state_->changed.wait(lock, [this] { return state_->idle(); });
}

bool TaskRunner::wait_for(std::chrono::milliseconds longest) const {
  std::unique_lock lock(state_->mutex);
  return state_->changed.wait_for(lock, longest, [this] { return state_->idle(); });
}

/// Calls wake() without the lock; the runner does not end meanwhile, even if it left this thread.
void TaskRunner::State::wake_from(std::unique_lock<std::mutex> lock) {
  if (!wake) return;
  ++waking;
  lock.unlock();
  const auto woken = [&] {
    lock.lock();
    --waking;
    changed.notify_all();
  };
  try {
    wake();
  } catch (...) {
    woken();
    throw;
  }
  woken();
}

void TaskRunner::State::report(Entry& entry, float share, const std::string& sentence) {
  std::unique_lock lock(mutex);
  if (!is_wanted(entry)) return;
  ShownTask& shown = entry.shown;
  const bool other = !sentence.empty() && sentence != shown.sentence;
  if (!other && std::abs(share - shown.share) < kStep) return;
  shown.share = std::clamp(share, 0.0f, 1.0f);
  if (other) shown.sentence = sentence;
  wake_from(std::move(lock));
}

void TaskRunner::State::deliver(const Entry& entry, std::function<void()> result) {
  std::unique_lock lock(mutex);
  if (!is_wanted(entry)) return;
  results.push_back({entry.stop.get_token(), std::move(result)});
  wake_from(std::move(lock));
}

/// Who asked waits for an answer, so a lack of memory only delays it.
void TaskRunner::tell_failure(const Task& task, const Error& why, const RunningTask& running) {
  constexpr int kTries = 500;
  constexpr std::chrono::milliseconds kPause{10};
  for (int i = 0; i < kTries && !running.stopped(); ++i) {
    if (caught([&] { task.failed(why, running); })) return;
    std::this_thread::sleep_for(kPause);
  }
}

/// What the task holds goes before anyone is told that it is done.
void TaskRunner::run(const std::shared_ptr<State>& state, const std::shared_ptr<Entry>& entry) noexcept {
  try {
    Task task = std::move(entry->task);
    const RunningTask running(
        entry->stop.get_token(),
        [&](float share, const std::string& sentence) { state->report(*entry, share, sentence); },
        [&](std::function<void()> result) { state->deliver(*entry, std::move(result)); });
    try {
      task.work(running);
    } catch (...) {
      const Failure why = thrown(ErrorKind::kInput);
      task.work = nullptr;  // perhaps there is memory then to say so
      if (task.failed) tell_failure(task, why.value(), running);
    }
  } catch (...) {  // nobody is left to be told
  }
}

/// The loop of one thread: until the runner ends, or goes on without it.
void TaskRunner::work(const std::shared_ptr<State>& state, int number) {
  std::unique_lock lock(state->mutex);
  while (state->thread == number) {
    state->changed.wait(lock, [&] { return state->closing || !state->waiting.empty(); });
    if (state->waiting.empty()) break;
    std::shared_ptr<Entry> entry = state->running = std::move(state->waiting.front());
    state->waiting.pop_front();
    lock.unlock();
    run(state, entry);
    entry.reset();
    lock.lock();
    if (state->thread == number) state->running = nullptr;
    state->changed.notify_all();
  }
  --state->alive;
  state->changed.notify_all();
}

}  // namespace weftlight::base
