#include "session/recovery/journal.h"

#include <filesystem>
#include <utility>

#include "base/caught.h"
#include "base/text.h"
#include "platform/file.h"
#include "wif/wif.h"

namespace weftlight::session {

using base::arg, base::caught, base::ErrorKind, base::fill, base::mark, base::tr, base::write_file_atomically;
using platform::File;

namespace {

using Clock = std::chrono::steady_clock;
using namespace std::chrono_literals;

constexpr auto kPause = 100ms;  // between two entries: a drag makes sixty states per second
constexpr auto kRetry = 1s;
/// A journal that has grown to this size is started again, because reading goes through all of it.
constexpr size_t kMaxEntries = 500, kMaxAppended = size_t{4} << 20;

/// Appends to an existing file, or writes a new one.
base::Result<void> append(const std::string& path, std::string_view bytes, File::Open how = File::Open::kAppend) {
  File file(path, how);
  std::error_code error = file.error() ? file.error() : file.write(bytes);
  if (const std::error_code closed = file.close(); !error) error = closed;
  if (error) return base::failure(ErrorKind::kOutput, error.message(), path);
  return {};
}

/// Waits until the file and its folder are on the disk. A removed file is no error.
base::Result<void> flush_to_disk(const std::string& path) {
  for (const std::string& what : {path, std::filesystem::path(path).parent_path().string()}) {
    const std::error_code error = platform::sync(what);
    const bool removed = error == std::errc::no_such_file_or_directory || error == std::errc::not_a_directory;
    if (error && !removed)
      return base::failure(ErrorKind::kOutput, fill(tr("The recovery copy may not be on the disk ({file}): {problem}"),
                                                    arg("file", path), arg("problem", error.message())));
  }
  return {};
}

/// `text` with the error as its {problem}; the error alone when there is no memory for more.
base::Failure said(const char* text, base::Error error) {
  caught([&] { error = {error.kind, fill(tr(text), arg("problem", message(error)))}; });
  return base::Failure(std::move(error));
}

}  // namespace

Journal::Journal(Recovery& recovery)
    : recovery_(recovery), thread_([this] { work(); }), flusher_([this] { flush(); }) {}

Journal::~Journal() {
  {
    const std::lock_guard lock(mutex_);
    leaving_ = true;
  }
  wake_.notify_one();
  thread_.join();
  {
    const std::lock_guard lock(mutex_);
    written_all_ = true;
  }
  flush_.notify_one();
  flusher_.join();
}

/// The newest request for a document replaces the waiting one.
void Journal::post(uint64_t document, WaitingWork task) {
  {
    const std::lock_guard lock(mutex_);
    WaitingWork& waiting = waiting_[document];
    task.then.splice(task.then.begin(), waiting.then);
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
  return errors_.empty() ? problem_of(flushed_) : message(errors_.begin()->second);
}

bool Journal::busy() const {
  const std::lock_guard lock(mutex_);
  return working_ || !waiting_.empty() || flushing_ || !unflushed_.empty();
}

bool Journal::settled() const {
  const bool flushed = !flushing_ && unflushed_.empty();
  return !working_ && flushed && (waiting_.empty() || !errors_.empty());
}

void Journal::settle() {
  std::unique_lock lock(mutex_);
  settled_.wait(lock, [this] { return settled(); });
}

void Journal::settle_for(std::chrono::milliseconds longest) {
  std::unique_lock lock(mutex_);
  settled_.wait_for(lock, longest, [this] { return settled(); });
}

void Journal::flush() {
  std::unique_lock lock(mutex_);
  for (;;) {
    flush_.wait(lock, [this] { return written_all_ || !unflushed_.empty(); });
    if (unflushed_.empty()) return;
    const auto journals = std::exchange(unflushed_, {});
    flushing_ = true;
    lock.unlock();
    base::Result<void> done;
    base::Result<void> ran = caught([&] {
      for (const std::string& path : journals)
        if (base::Result<void> one = flush_to_disk(path); !one) done = std::move(one);
    });
    if (!ran) done = said(mark("The recovery copy may not be on the disk: {problem}"), std::move(ran).error());
    lock.lock();
    flushing_ = false;
    begin_anew_ |= !done;
    flushed_ = std::move(done);
    settled_.notify_all();
  }
}

void Journal::work() {
  caught([this] { recovery_.open(); });  // early; the first entry reports an error
  std::unique_lock lock(mutex_);
  for (;;) {
    wake_.wait(lock, [this] { return leaving_ || !waiting_.empty(); });
    // The pause counts from the last entry, so that a single change is written at once.
    wake_.wait_until(lock, next_, [this] { return leaving_; });
    const bool last = leaving_;
    auto tasks = std::exchange(waiting_, {});
    working_ = true;
    next_ = Clock::now() + kPause;
    while (!tasks.empty()) {
      auto task = tasks.extract(tasks.begin());
      lock.unlock();
      base::Result<void> done;
      base::Result<void> ran = caught([&] { done = perform(task.key(), task.mapped()); });
      if (!ran) done = said(mark("No recovery copy: {problem}"), std::move(ran).error());
      lock.lock();
      if (done) errors_.erase(task.key());
      else try_again(std::move(task), std::move(done).error());
    }
    working_ = false;
    settled_.notify_all();
    if (last) return;
  }
}

/// Allocates nothing before the task is queued again, since the error may be a lack of memory.
void Journal::try_again(std::map<uint64_t, WaitingWork>::node_type task, base::Error error) {
  next_ = Clock::now() + kRetry;
  const uint64_t document = task.key();
  if (auto placed = waiting_.insert(std::move(task)); !placed.inserted) {
    WaitingWork &newer = placed.position->second, &older = placed.node.mapped();
    newer.then.splice(newer.then.end(), older.then);
    if (!newer.keep && !newer.forget) {
      newer.keep = std::move(older.keep);
      newer.forget = older.forget;
    }
  }
  caught([&] { errors_[document] = std::move(error); });
}

base::Result<void> Journal::perform(uint64_t document, const WaitingWork& task) {
  base::Result<void> done;
  if (task.keep) done = write(document, *task.keep);
  if (task.forget) {
    written_.erase(document);
    std::error_code error;
    std::filesystem::remove(recovery_.journal_path(document), error);
    if (error && error != std::errc::not_a_directory)
      done = base::failure(ErrorKind::kOutput, error.message(), recovery_.journal_path(document));
  }
  if (done && !task.then.empty()) done = flush_to_disk(recovery_.journal_path(document));
  if (done)
    for (const LeftWork& left : task.then) recovery_.discard(left);
  return done;
}

base::Result<void> Journal::write(uint64_t document, const State& state) {
  Written& written = written_[document];
  const std::string path = recovery_.journal_path(document);
  std::string text = state.make_text();
  std::unique_lock lock(mutex_);
  if (std::exchange(begin_anew_, false))
    for (auto& [other, journal] : written_) journal.whole = false;
  lock.unlock();
  bool done = false;
  if (written.whole && written.note == state.note && written.entries < kMaxEntries && written.appended < kMaxAppended) {
    const std::string entry = journal_entry(written.text, text);
    done = append(path, entry).has_value();
    ++written.entries;
    written.appended += entry.size();
  }
  if (!done) {
    // The first entry, or the journal is torn or too long.
    written.whole = false;
    const auto no_copy = [&](const base::Error& error) {
      return base::failure(error.kind, fill(tr("No recovery copy of {draft}: {problem}"), arg("draft", state.note.name),
                                            arg("problem", message(error))));
    };
    if (const base::Result<void> opened = recovery_.open(); !opened) return no_copy(opened.error());
    const std::string start = journal_start({state.note, text});
    base::Result<void> begun = append(path, start, File::Open::kCreate);
    if (!begun) begun = write_file_atomically(path, start);
    if (!begun) return no_copy(begun.error());
    written = {state.note, {}, 0, 0, true};
  }
  written.text = std::move(text);
  lock.lock();
  unflushed_.insert(path);
  flush_.notify_one();
  return {};
}

}  // namespace weftlight::session
