#include "session/jobs/background_writer.h"

#include <algorithm>
#include <utility>

#include "base/caught.h"

namespace weftlight::session {

using base::caught;

namespace {

using Clock = std::chrono::steady_clock;
constexpr std::chrono::seconds kRetry{1};

}  // namespace

BackgroundWriter::BackgroundWriter() : thread_([this] { work(); }) {}

BackgroundWriter::~BackgroundWriter() {
  {
    const std::lock_guard lock(mutex_);
    leaving_ = true;
  }
  wake_.notify_one();
  thread_.join();
}

void BackgroundWriter::keep(const std::string& path, Job job) {
  {
    const std::lock_guard lock(mutex_);
    waiting_[path] = std::move(job);
  }
  wake_.notify_one();
}

void BackgroundWriter::drop(const std::string& path) {
  keep(path, [] { return base::Result<void>(); });  // replaces a waiting job and stops its retries
}

std::string BackgroundWriter::problem() const {
  const std::lock_guard lock(mutex_);
  return errors_.empty() ? std::string() : message(errors_.begin()->second);
}

bool BackgroundWriter::busy() const {
  const std::lock_guard lock(mutex_);
  return working_ || !waiting_.empty();
}

BackgroundWriter::Jobs::iterator BackgroundWriter::due() {
  const bool now = leaving_ || Clock::now() >= retry_;
  return std::find_if(waiting_.begin(), waiting_.end(),
                      [&](const auto& job) { return now || !errors_.contains(job.first); });
}

void BackgroundWriter::work() {
  std::unique_lock lock(mutex_);
  for (;;) {
    if (waiting_.empty()) wake_.wait(lock, [this] { return leaving_ || !waiting_.empty(); });
    else wake_.wait_until(lock, retry_, [this] { return leaving_ || due() != waiting_.end(); });
    if (waiting_.empty() && leaving_) return;
    const auto next = due();
    if (next == waiting_.end()) continue;
    auto job = waiting_.extract(next);
    working_ = true;
    lock.unlock();
    base::Result<void> written = caught(job.mapped(), base::ErrorKind::kOutput);
    lock.lock();
    working_ = false;
    errors_.erase(job.key());
    if (written || leaving_) continue;  // the last try at exit
    retry_ = Clock::now() + kRetry;
    const auto placed = waiting_.insert(std::move(job));  // does nothing if a newer job waits
    caught([&] { errors_[placed.position->first] = std::move(written).error(); });
  }
}

}  // namespace weftlight::session
