#include "session/journal.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <utility>

#include "wif/wif.h"

namespace weftlight::session {
namespace {

using Clock = std::chrono::steady_clock;
using namespace std::chrono_literals;

constexpr auto kPause = 100ms;  // between two entries: a drag makes sixty states a second
constexpr auto kRetry = 1s;
/// A journal is begun anew when it has grown so far: reading goes through all of it.
constexpr size_t kMostEntries = 500, kMostAppended = size_t{4} << 20;

/// Appends to a file that is there; what went wrong, or empty.
std::string append(const std::string& path, std::string_view bytes) {
  const int file = ::open(path.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC);
  if (file < 0) return path + ": " + std::strerror(errno);
  std::string problem;
  while (!bytes.empty() && problem.empty()) {
    const ssize_t n = ::write(file, bytes.data(), bytes.size());
    if (n < 0 && errno != EINTR) problem = path + ": " + std::strerror(errno);
    if (n > 0) bytes.remove_prefix(static_cast<size_t>(n));
  }
  if (problem.empty() && ::fsync(file) != 0) problem = path + ": " + std::strerror(errno);
  ::close(file);
  return problem;
}

}  // namespace

Journal::Journal(Recovery& recovery) : recovery_(recovery), thread_([this] { work(); }) {}

Journal::~Journal() {
  {
    const std::lock_guard lock(mutex_);
    leaving_ = true;
  }
  wake_.notify_one();
  thread_.join();
}

/// The newest of what is asked of a document wins.
void Journal::post(uint64_t document, Task task) {
  {
    const std::lock_guard lock(mutex_);
    Task& waiting = waiting_[document];
    task.then.insert(task.then.begin(), waiting.then.begin(), waiting.then.end());
    if (!task.keep && !task.forget) {
      task.keep = std::move(waiting.keep);
      task.forget = waiting.forget;
    }
    waiting = std::move(task);
  }
  wake_.notify_one();
}

void Journal::keep(uint64_t document, DocumentNote note, std::function<std::string()> make_text) {
  post(document, {State{std::move(note), std::move(make_text)}, false, {}});
}

void Journal::forget(uint64_t document) { post(document, {{}, true, {}}); }

void Journal::replace(const LeftWork& left, uint64_t document) { post(document, {{}, false, {left}}); }

void Journal::discard(const LeftWork& left) { replace(left, 0); }

std::string Journal::problem() const {
  const std::lock_guard lock(mutex_);
  return problems_.empty() ? std::string() : problems_.begin()->second;
}

bool Journal::busy() const {
  const std::lock_guard lock(mutex_);
  return working_ || !waiting_.empty();
}

void Journal::settle() {
  std::unique_lock lock(mutex_);
  settled_.wait(lock, [this] { return !working_ && (waiting_.empty() || !problems_.empty()); });
}

void Journal::work() {
  std::unique_lock lock(mutex_);
  for (;;) {
    wake_.wait(lock, [this] { return leaving_ || !waiting_.empty(); });
    // Only the time of the last entry is waited for, so that a single change is written at once.
    wake_.wait_until(lock, next_, [this] { return leaving_; });
    const bool last = leaving_;
    auto tasks = std::exchange(waiting_, {});
    working_ = true;
    next_ = Clock::now() + kPause;
    for (auto& [document, task] : tasks) {
      lock.unlock();
      std::string problem;
      try {
        problem = perform(document, task);
      } catch (const std::exception& e) {  // no memory
        problem = "No recovery copy: " + std::string(e.what());
      }
      lock.lock();
      if (problem.empty()) {
        problems_.erase(document);
        continue;
      }
      next_ = Clock::now() + kRetry;
      problems_[document] = std::move(problem);
      Task& newer = waiting_[document];
      newer.then.insert(newer.then.end(), task.then.begin(), task.then.end());
      if (newer.keep || newer.forget) continue;
      newer.keep = std::move(task.keep);
      newer.forget = task.forget;
    }
    working_ = false;
    settled_.notify_all();
    if (last) return;
  }
}

std::string Journal::perform(uint64_t document, const Task& task) {
  std::string problem;
  if (task.keep) problem = write(document, *task.keep);
  if (task.forget) {
    written_.erase(document);
    std::error_code error;
    std::filesystem::remove(recovery_.journal_path(document), error);
    if (error && error != std::errc::not_a_directory)
      problem = recovery_.journal_path(document) + ": " + error.message();
  }
  if (problem.empty())
    for (const LeftWork& left : task.then) recovery_.discard(left);
  return problem;
}

std::string Journal::write(uint64_t document, const State& state) {
  Written& written = written_[document];
  const std::string path = recovery_.journal_path(document);
  std::string text = state.make_text();
  if (written.whole && written.note == state.note && written.entries < kMostEntries &&
      written.appended < kMostAppended) {
    const std::string entry = journal_entry(written.text, text);
    if (append(path, entry).empty()) {
      written.text = std::move(text);
      ++written.entries;
      written.appended += entry.size();
      return {};
    }
    // Torn, or taken away: begun anew beside it.
    written.whole = false;
  }
  std::string problem = recovery_.open();
  if (problem.empty()) problem = write_file_atomically(path, journal_start({state.note, text}));
  if (!problem.empty()) return "No recovery copy of " + state.note.name + " (" + path + "): " + problem;
  written = {state.note, std::move(text), 0, 0, true};
  return {};
}

}  // namespace weftlight::session
