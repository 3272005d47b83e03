#include "base/worker.h"

#include <algorithm>

#include "base/caught.h"

namespace weftlight::base {

Worker::Worker(Leaving leaving, Failed failed)
    : leaving_(leaving), failed_(std::move(failed)), thread_([this] { work(); }) {}

Worker::~Worker() {
  {
    const std::lock_guard lock(mutex_);
    closing_ = true;
    if (leaving_ == Leaving::kDrop) {
      waiting_.clear();
      stop_.request_stop();
    }
  }
  changed_.notify_all();
  thread_.join();
}

void Worker::post(Job job, const std::string& kind) {
  {
    const std::lock_guard lock(mutex_);
    if (working_ && kind_ == kind) stop_.request_stop();
    const auto same = std::find_if(waiting_.begin(), waiting_.end(), [&](const auto& w) { return w.first == kind; });
    if (same != waiting_.end()) same->second = std::move(job);
    else waiting_.emplace_back(kind, std::move(job));
  }
  changed_.notify_all();
}

void Worker::drop() {
  {
    const std::lock_guard lock(mutex_);
    waiting_.clear();
    stop_.request_stop();
  }
  changed_.notify_all();
}

bool Worker::busy() const {
  const std::lock_guard lock(mutex_);
  return !waiting_.empty() || (working_ && !stop_.stop_requested());
}

void Worker::wait() const {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [this] { return waiting_.empty() && !working_; });
}

/// What the job holds goes before anyone is told that it is done.
void Worker::run(Job job, const std::stop_token& stop) const noexcept {
  try {
    job(stop);
  } catch (...) {
    try {
      const std::string why = words_of_thrown();
      job = nullptr;  // perhaps there is memory then to say so
      if (failed_ && !stop.stop_requested()) failed_(why, stop);
    } catch (...) {  // nobody is left to be told
    }
  }
}

void Worker::work() {
  std::unique_lock lock(mutex_);
  for (;;) {
    changed_.wait(lock, [this] { return closing_ || !waiting_.empty(); });
    if (waiting_.empty()) return;
    Job job = std::move(waiting_.front().second);
    kind_ = std::move(waiting_.front().first);
    waiting_.erase(waiting_.begin());
    stop_ = {};
    working_ = true;
    const std::stop_token stop = stop_.get_token();
    lock.unlock();
    run(std::move(job), stop);
    lock.lock();
    working_ = false;
    changed_.notify_all();
  }
}

}  // namespace weftlight::base
