#pragma once
// Long work beside the window. A task runs on the thread of its runner, reports its progress, can be asked to stop, and
// delivers its results to the thread that asked for it. What it throws ends that task alone and is told as a message.

#include <chrono>
#include <condition_variable>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <stop_token>
#include <string>
#include <thread>
#include <type_traits>
#include <utility>
#include <vector>

#include "base/progress.h"
#include "base/result.h"

namespace weftlight::base {

/// A task while it runs.
class RunningTask : public TaskProgress {
 public:
  /// take() runs `result` on its own thread, unless the task is stopped before.
  void deliver(std::function<void()> result) const { deliver_(std::move(result)); }

 private:
  friend class TaskRunner;
  RunningTask(std::stop_token stop, Listener listener, std::function<void(std::function<void()>)> deliver)
      : TaskProgress(std::move(stop), std::move(listener)), deliver_(std::move(deliver)) {}
  std::function<void(std::function<void()>)> deliver_;
};

struct Task {
  std::function<void(const RunningTask&)> work;
  /// Called on the thread of the task with the error of what it threw, unless the task was stopped.
  std::function<void(const Error& error, const RunningTask&)> failed = {};
  std::string kind = {};  // of two tasks of one kind the newer counts
  std::string name = {};  // for the user, while it runs or waits: "Saving twill.wif"; empty: not shown
  bool finishes = false;  // once asked for it is done: it is never stopped, even where the runner ends
  // What may hang, as reading from a share does: stopped while it runs, it is left to its thread, and nobody waits for
  // it, the end of the program no longer than a second. `work` therefore owns all that it uses, and ends soon if it
  // ever goes on.
  bool may_be_left = false;
};

/// Result<T> for T and for Result<T>.
template <class T>
struct AsResult {
  using Type = Result<T>;
};
template <class T>
struct AsResult<Result<T>> {
  using Type = Result<T>;
};

/// A task with one result: `work` returns a T or a Result<T>, and take() runs `done` with the Result<T>, which is an
/// error also if `work` threw.
template <class Work, class Done>
Task task_with_result(Work work, Done done) {
  using Made = typename AsResult<std::invoke_result_t<const Work&, const RunningTask&>>::Type;
  Task task;
  task.work = [work = std::move(work), done](const RunningTask& running) {
    auto result = std::make_shared<Made>(work(running));
    running.deliver([done, result] { done(std::move(*result)); });
  };
  task.failed = [done = std::move(done)](const Error& error, const RunningTask& running) {
    running.deliver([done, error] { done(Made(Failure(error))); });
  };
  return task;
}

/// A task as users see it.
struct ShownTask {
  std::string name, sentence;
  std::string kind;
  float share = 0;  // 0..1
  bool can_stop = false;
  std::chrono::steady_clock::time_point since{};  // when it was asked for
};

/// A thread that runs tasks one after the other, oldest first. A newer task replaces a waiting one of the same kind and
/// asks a running one to stop. Another thread takes its place where it is left to a task (Task::may_be_left).
class TaskRunner {
 public:
  /// `wake` is called on the runner's thread, without any lock, when there is something to show or to take.
  explicit TaskRunner(std::function<void()> wake = {});
  /// Drops or finishes the waiting tasks (Task::finishes) and waits for the running one, for one that may be left no
  /// longer than a second. Results are not taken any more.
  ~TaskRunner();
  TaskRunner(const TaskRunner&) = delete;
  TaskRunner& operator=(const TaskRunner&) = delete;

  void start(Task task);
  /// Removes the waiting task of this kind and asks the running one to stop, or leaves it; its results are not taken.
  void stop(const std::string& kind);
  /// The same for all kinds.
  void stop();
  /// Runs what the tasks delivered, in order. True if there was anything.
  bool take();

  /// True if a task waits, or runs without a request to stop.
  bool busy() const;
  bool busy(const std::string& kind) const;
  /// The tasks with a name: the running one, then the waiting ones.
  std::vector<ShownTask> shown() const;
  /// Blocks until no task waits or runs.
  void wait() const;
  /// The same for at most this time; true if none waits or runs.
  bool wait_for(std::chrono::milliseconds longest) const;

 private:
  struct Entry {
    Task task;
    ShownTask shown;
    std::stop_source stop;
  };
  struct Result {
    std::stop_token stop;
    std::function<void()> run;
  };
  using Entries = std::deque<std::shared_ptr<Entry>>;

  /// What the runner shares with its threads, those included that it left. It is all that these may use.
  struct State {
    explicit State(std::function<void()> wake_) : wake(std::move(wake_)) {}
    const std::function<void()> wake;
    std::mutex mutex;  // protects all members below
    std::condition_variable changed;
    Entries waiting;  // oldest first, one of a kind
    std::shared_ptr<Entry> running;
    std::deque<Result> results;
    int thread = 0;  // the number of the one that works; those before were left
    int alive = 0;   // threads, those that were left included
    int waking = 0;  // threads in wake()
    bool closing = false;

    bool idle() const { return waiting.empty() && running == nullptr; }
    void report(Entry& entry, float share, const std::string& sentence);
    void deliver(const Entry& entry, std::function<void()> result);
    void wake_from(std::unique_lock<std::mutex> lock);
  };

  template <class Chosen>
  bool request_stop(Chosen chosen);
  template <class Chosen>
  void stop_if(Chosen chosen);
  void leave_running();
  static bool is_wanted(const Entry& entry);
  static void run(const std::shared_ptr<State>& state, const std::shared_ptr<Entry>& entry) noexcept;
  static void work(const std::shared_ptr<State>& state, int number);
  std::thread begin(int number) const;

  const std::shared_ptr<State> state_;
  std::thread thread_;
};

}  // namespace weftlight::base
