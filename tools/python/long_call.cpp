#include "python/long_call.h"

#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <string>
#include <thread>

namespace weftlight::python {

using base::ErrorKind, base::TaskProgress;

namespace {

constexpr auto kSignalStep = std::chrono::milliseconds(50);  // the longest time that Ctrl+C waits

struct News {
  float share = 0;
  std::string sentence;
  bool reported = false;  // since the last news
  bool done = false;
};

/// What the working thread tells the waiting one: the latest report alone.
class NewsLine {
 public:
  void report(float share, const std::string& sentence) {
    const std::lock_guard lock(mutex_);
    news_.share = share, news_.reported = true;
    if (!sentence.empty()) news_.sentence = sentence;
    changed_.notify_one();
  }
  void end() {
    const std::lock_guard lock(mutex_);
    news_.done = true;
    changed_.notify_one();
  }
  News wait() {
    std::unique_lock lock(mutex_);
    changed_.wait_for(lock, kSignalStep, [this] { return news_.reported || news_.done; });
    News news = news_;
    news_.reported = false;
    return news;
  }

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  News news_;
};

/// False if the callback says so. Throws what it, or the handler of a signal, raises.
bool goes_on(const py::object& progress, const News& news) {
  if (PyErr_CheckSignals() != 0) throw py::error_already_set();
  if (!news.reported || progress.is_none()) return true;
  return !progress(news.share, news.sentence).is(py::bool_(false));
}

}  // namespace

void run_long(const py::object& progress, const std::function<void(const TaskProgress&)>& work) {
  if (!progress.is_none() && !PyCallable_Check(progress.ptr()))
    throw py::type_error("progress must be a function of a share and a sentence, or None");
  NewsLine line;
  std::stop_source stop;
  std::exception_ptr of_work, of_python;
  const TaskProgress task(stop.get_token(), [&line](float share, const std::string& s) { line.report(share, s); });
  std::thread worker([&] {
    try {
      work(task);
    } catch (...) {
      of_work = std::current_exception();
    }
    line.end();
  });
  while (true) {
    const News news = unlocked([&line] { return line.wait(); });
    if (news.done) break;
    if (stop.stop_requested()) continue;
    try {
      if (!goes_on(progress, news)) stop.request_stop();
    } catch (...) {
      of_python = std::current_exception();
      stop.request_stop();
    }
  }
  unlocked([&worker] { worker.join(); });
  if (of_python) std::rethrow_exception(of_python);
  if (stop.stop_requested()) throw Failed({ErrorKind::kCancelled, "stopped, as the progress callback returned False"});
  if (of_work) std::rethrow_exception(of_work);
  if (!progress.is_none()) progress(1.0f, "");
}

}  // namespace weftlight::python
