#include "session/background_writer.h"

#include <filesystem>
#include <utility>

#include "wif/wif.h"

namespace weftlight::session {

BackgroundWriter::BackgroundWriter() : thread_([this] { work(); }) {}

BackgroundWriter::~BackgroundWriter() {
  {
    const std::lock_guard lock(mutex_);
    leaving_ = true;
  }
  wake_.notify_one();
  thread_.join();
}

void BackgroundWriter::write(const std::string& path, std::function<std::string()> make_bytes) {
  post(path, [path, make = std::move(make_bytes)] { return write_file_atomically(path, make()); });
}

void BackgroundWriter::remove(const std::string& path) {
  post(path, [path] {
    std::error_code ignored;  // it need not be there
    std::filesystem::remove(path, ignored);
    return std::string();
  });
}

void BackgroundWriter::run(const std::string& path, std::string done, std::function<std::string()> job) {
  post(path, [this, done = std::move(done), job = std::move(job)] {
    std::string problem = job();
    const std::lock_guard lock(mutex_);
    if (problem.empty()) message_ = done;
    return problem;
  });
}

bool BackgroundWriter::busy() {
  const std::lock_guard lock(mutex_);
  return working_ || !waiting_.empty() || !message_.empty() || !error_.empty();
}

std::string BackgroundWriter::take_message() {
  const std::lock_guard lock(mutex_);
  return std::exchange(message_, {});
}

std::string BackgroundWriter::take_error() {
  const std::lock_guard lock(mutex_);
  return std::exchange(error_, {});
}

void BackgroundWriter::post(const std::string& path, Job job) {
  {
    const std::lock_guard lock(mutex_);
    waiting_[path] = std::move(job);
  }
  wake_.notify_one();
}

void BackgroundWriter::work() {
  std::unique_lock lock(mutex_);
  for (;;) {
    wake_.wait(lock, [this] { return leaving_ || !waiting_.empty(); });
    if (waiting_.empty()) return;
    auto job = waiting_.extract(waiting_.begin());
    working_ = true;
    lock.unlock();
    std::string problem = job.mapped()();
    lock.lock();
    working_ = false;
    if (!problem.empty()) error_ = std::move(problem);
  }
}

}  // namespace weftlight::session
